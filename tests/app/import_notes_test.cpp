/// What the import remarks is said in the window, above the picture that it is about.

#include <QTemporaryDir>
#include <QTest>

#include "app/desktop.h"
#include "app/looks.h"
#include "tests/support/patience.h"
#include "tests/support/phantom_series.h"

namespace pdr::app {

class TestImportNotes : public QObject {
    Q_OBJECT

  private slots:
    void theWindowSaysWhatTheImportRemarked_data() {
        QTest::addColumn<bool>("withCopy");
        QTest::addColumn<QString>("said");
        QTest::newRow("a slice that is there twice") << true << "1 copy of a slice left out";
        QTest::newRow("nothing to remark") << false << "";
    }
    void theWindowSaysWhatTheImportRemarked() {
        QFETCH(bool, withCopy);
        QFETCH(QString, said);
        const QTemporaryDir folder;
        const std::filesystem::path series = folder.filePath("series").toStdString();
        QVERIFY(bool(writePhantomSeries(series)));
        if (withCopy)
            std::filesystem::copy_file(series / "slice00003.dcm", series / "again.dcm");
        Desktop desktop(*bundledLooks(), makeCpuDevice(1), folder.filePath("settings.ini"), 1);
        desktop.open(folder.filePath("series"));
        QTRY_VERIFY_WITH_TIMEOUT(desktop.parts().document.hasVolume(), test::kPatience);
        const QString text = desktop.window().message().text();
        QVERIFY2(said.isEmpty() ? text.isEmpty() : text.startsWith(said), qPrintable(text));
        QCOMPARE(desktop.parts().document.scene().volume->remarks(), std::string(withCopy ? "copies" : ""));
    }
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestImportNotes)
#include "import_notes_test.moc"
