/// The dialogs for files leave no trace: a folder's name may be a patient's.

#include <QDirIterator>
#include <QFileDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "ui/output/picture_size_box.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

/// The folder for everything that Qt saves for the user.
static QTemporaryDir& home() {
    static QTemporaryDir folder;
    return folder;
}

class TestFileDialogs : public QObject {
    Q_OBJECT

  public:
    static void initMain() {
        for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "HOME"})
            qputenv(place, home().path().toUtf8());
    }

  private slots:
    void init();
    void cleanup();
    void whereTheHandWasIsNotKept_data();
    void whereTheHandWasIsNotKept();
    void whatWasKeptByOtherProgramsStays();
    void theDialogForSavingGoesWithItsPicture();
    void aPictureOfAnotherSizeIsOrderedWithItsTarget();
    void savingBeginsWhereTheLastPictureIs();

  private:
    /// Opens the dialog with `key`, goes to the patient's folder and takes what is there, or gives up.
    void use(MainWindow& window, const QKeySequence& key, bool accept);

    std::unique_ptr<QTemporaryDir> place_;
    QString patient_;  ///< a folder
};

void TestFileDialogs::init() {
    place_ = std::make_unique<QTemporaryDir>();
    patient_ = place_->filePath("Mustermann^Erika");
    QVERIFY(QDir().mkpath(patient_ + "/series"));
}

void TestFileDialogs::cleanup() {
    QSettings(QSettings::UserScope, "QtProject").clear();
}

void TestFileDialogs::use(MainWindow& window, const QKeySequence& key, bool accept) {
    bool used = false;
    QTimer::singleShot(0, &window, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        dialog->setDirectory(patient_);
        dialog->selectFile(patient_ + (dialog->acceptMode() == QFileDialog::AcceptSave ? "/picture.png" : "/series"));
        used = true;
        accept ? static_cast<QDialog*>(dialog)->accept() : dialog->reject();
    });
    for (QAction* action : window.findChildren<QAction*>())
        if (action->shortcut() == key)
            action->trigger();
    QVERIFY(used);
}

void TestFileDialogs::whereTheHandWasIsNotKept_data() {
    QTest::addColumn<bool>("accept");
    QTest::newRow("accepted") << true;
    QTest::newRow("given up") << false;
}

void TestFileDialogs::whereTheHandWasIsNotKept() {
    QFETCH(bool, accept);
    QString opened, saved;
    {
        MainWindow window;
        window.setPictureAvailable(true);
        connect(&window, &MainWindow::folderChosen, this, [&](const QString& folder) { opened = folder; });
        connect(&window, &MainWindow::saveRequested, this, [&](const QString& file) { saved = file; });
        window.setLastFolder(patient_);
        window.show();
        for (int i = 0; i < 2; ++i) {
            use(window, QKeySequence::Open, accept);
            use(window, QKeySequence::Save, accept);
        }
    }
    QCOMPARE(opened, accept ? patient_ + "/series" : QString());
    QCOMPARE(saved, accept ? patient_ + "/picture.png" : QString());
    QDirIterator files(home().path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray content = file.readAll();
        QVERIFY2(!content.contains("Mustermann") && !content.contains("Erika"),
                 qPrintable(file.fileName() + ":\n" + content));
    }
}

void TestFileDialogs::whatWasKeptByOtherProgramsStays() {
    const QStringList theirs{"file:///music", "file:///pictures"};
    {
        QSettings settings(QSettings::UserScope, "QtProject");
        settings.setValue("FileDialog/history", theirs);
    }
    {
        MainWindow window;
        window.show();
        use(window, QKeySequence::Open, true);
    }
    QCOMPARE(QSettings(QSettings::UserScope, "QtProject").value("FileDialog/history").toStringList(), theirs);
}

void TestFileDialogs::theDialogForSavingGoesWithItsPicture() {
    MainWindow window;
    window.setPictureAvailable(true);
    window.show();
    int saved = 0, seen = 0;
    connect(&window, &MainWindow::saveRequested, this, [&] { ++saved; });
    QTimer::singleShot(0, &window, [&] {
        seen += qobject_cast<QFileDialog*>(QApplication::activeModalWidget()) != nullptr;
        window.setPictureAvailable(false);
    });
    for (QAction* action : window.findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QKeySequence::Save))
            action->trigger();  // comes back
    QCOMPARE(seen, 1);
    QCOMPARE(saved, 0);
}

/// The target is good for planning unless another is chosen.
void TestFileDialogs::aPictureOfAnotherSizeIsOrderedWithItsTarget() {
    MainWindow window;
    window.setPictureAvailable(true);
    window.show();
    int saved = 0;
    std::optional<PictureOrder> ordered;
    connect(&window, &MainWindow::saveRequested, this, [&] { ++saved; });
    connect(&window, &MainWindow::pictureOrdered, this, [&](const PictureOrder& order) { ordered = order; });
    QTimer::singleShot(0, &window, [&] {
        const auto* box = QApplication::activeModalWidget()->findChild<PictureSizeBox*>();
        QVERIFY(box && box->isVisible());
        box->findChild<QComboBox*>()->setCurrentIndex(2);
    });
    use(window, QKeySequence::Save, true);
    QVERIFY(ordered && saved == 0);
    QCOMPARE(ordered->file, patient_ + "/picture.png");
    QVERIFY(ordered->size == QSize(2000, 2000));
    QVERIFY((ordered->stop == StopRule{.levels = 8}));
    QVERIFY(ordered->annotate == Annotate::sides);
}

/// Saving begins in the documents folder, then in the last image's folder, also after other dialogs, under the proposed
/// name.
void TestFileDialogs::savingBeginsWhereTheLastPictureIs() {
    QVERIFY(QDir().mkpath(home().filePath("Documents")));
    MainWindow window;
    window.setPictureAvailable(true);
    window.setPictureOffer("Bone_A_2026-11-25", {});
    window.show();
    const auto beginsAt = [&](QString& name) {
        QString folder;
        QTimer::singleShot(0, &window, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            folder = dialog->directory().absolutePath();
            name = dialog->selectedFiles().value(0);
            dialog->reject();
        });
        for (QAction* action : window.findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(QKeySequence::Save))
                action->trigger();
        return folder;
    };
    QString name;
    QCOMPARE(beginsAt(name), home().filePath("Documents"));
    QVERIFY2(name.endsWith("/Bone_A_2026-11-25.png"), qPrintable(name));
    use(window, QKeySequence::Save, true);
    use(window, QKeySequence::Open, false);
    QCOMPARE(beginsAt(name), patient_);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestFileDialogs)
#include "file_dialogs_test.moc"
