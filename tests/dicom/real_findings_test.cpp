/// Findings in real scans.

#include <QTest>

#include "dicom/import.h"
#include "render/segment/findings.h"
#include "render/segment/hidden_table.h"
#include "render/volume/raw_file.h"
#include "tests/support/dicom/shared_data.h"

using namespace pdr;
using segment::Findings;

namespace {

Findings foundOn(const Volume& scan) {
    const segment::HiddenTable table = *segment::hideTable(scan, noProgress);
    return segment::findingsOn(table.body ? *table.body : scan, table.bodyBox);
}

void tell(const Findings& findings) {
    qInfo("%.0f mm wide, lungs %.0f ml, metal %.2f ml, blood %.0f HU", findings.widthMm, findings.lungMl,
          findings.metalMl, double(findings.blood.value_or(0)));
}

}  // namespace

class RealFindingsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Flat bright regions of its heart and aorta were measured with another program: 367 to 480 HU (10 to 90 %), their
    /// noise in it.
    void aChestWithContrast() {
        PDR_NEEDS_SHARED_CT();
        const auto scan = dicom::scanFolder(test::sharedCt() / "chest_contrast", noProgress);
        QVERIFY(scan && scan->series.size() == 1);
        const auto volume = dicom::loadSeries(scan->series[0], dicom::Padding::maskAsAir, noProgress);
        QVERIFY(volume);
        const Findings findings = foundOn(*volume);
        tell(findings);
        QVERIFY(findings.blood && *findings.blood > 340 && *findings.blood < 480);
        QVERIFY(findings.widthMm > 300 && findings.lungMl > 1500);
    }

    void aHeadWithoutContrast() {
        const std::filesystem::path file = std::filesystem::path(PDR_SOURCE_DIR) / "build/example/matrix.dat";
        if (!std::filesystem::exists(file))
            PDR_SKIP_FOR_WANT_OF_DATA("the example's voxels are not there: ./bootstrap test unpacks them");
        const auto head = loadRaw({file, RawFile::Type::int16, {256, 256, 108}, {0.9570312, 0.9570312, 1.5}, {}});
        QVERIFY(head);
        const Findings findings = foundOn(*head);
        tell(findings);
        QVERIFY(!findings.blood && findings.widthMm < 200 && findings.lungMl < 100);
    }
};

QTEST_APPLESS_MAIN(RealFindingsTest)
#include "real_findings_test.moc"
