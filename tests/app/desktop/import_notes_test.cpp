/// What the import remarks is said in the window, above the image that it is about.

#include <QTemporaryDir>
#include <QTest>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"

namespace pdr::app {

class TestImportNotes : public QObject {
    Q_OBJECT

  private slots:
    void theWindowSaysWhatTheImportRemarked_data() {
        QTest::addColumn<QString>("copy");
        QTest::addColumn<QString>("emptied");
        QTest::addColumn<QString>("said");
        QTest::addColumn<QString>("remarks");
        QTest::newRow("a slice that is there twice") << "again.dcm"
                                                     << ""
                                                     << "1 copy of a slice left out"
                                                     << "copies";
        QTest::newRow("an end slice of which nothing is left")
            << ""
            << "slice00064.dcm"
            << "1 file could not be read, and slices of this series may be missing (slice00064.dcm)"
            << "unread";
        QTest::newRow("nothing to remark") << ""
                                           << ""
                                           << ""
                                           << "";
    }
    void theWindowSaysWhatTheImportRemarked() {
        QFETCH(QString, copy);
        QFETCH(QString, emptied);
        QFETCH(QString, said);
        QFETCH(QString, remarks);
        const QTemporaryDir folder;
        const std::filesystem::path series = folder.filePath("series").toStdString();
        QVERIFY(bool(writePhantomSeries(series)));
        if (!copy.isEmpty())
            std::filesystem::copy_file(series / "slice00003.dcm", series / copy.toStdString());
        if (!emptied.isEmpty())
            std::filesystem::resize_file(series / emptied.toStdString(), 0);
        Desktop desktop(*bundledLooks(), makeCpuDevice(1), folder.filePath("settings.ini"), 1);
        desktop.open(folder.filePath("series"));
        QTRY_VERIFY_WITH_TIMEOUT(desktop.document().hasVolume(), test::kPatience);
        const QString text = desktop.window().message().text();
        QVERIFY2(said.isEmpty() ? text.isEmpty() : text.startsWith(said), qPrintable(text));
        QCOMPARE(desktop.document().scene().volume->remarks(), remarks.toStdString());
    }
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestImportNotes)
#include "import_notes_test.moc"
