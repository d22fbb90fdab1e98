/// The dialogs for files leave no trace: a folder's name may be a patient's.

#include <QDirIterator>
#include <QFileDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/support/desktop/whole_window.h"
#include "ui/output/image_size_box.h"
#include "ui/output/save_dialog.h"
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
    void theDialogForSavingGoesWithItsImage();
    void anImageOfAnotherSizeIsOrderedWithItsTarget();
    void savingBeginsWithTheOffer();
    void savingBeginsWhereTheLastImageIs();

  private:
    /// Connects the action for saving to the dialog, which begins with `offer`; the order goes to `ordered`.
    void connectSaving(MainWindow& window, std::optional<ImageOrder>& ordered, const ImageOffer& offer = {});
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

void TestFileDialogs::connectSaving(MainWindow& window, std::optional<ImageOrder>& ordered, const ImageOffer& offer) {
    QAction* save = window.menuActions().save;
    save->setEnabled(true);
    connect(save, &QAction::triggered, this, [&, save, offer] { ordered = askForImage(&window, *save, offer); });
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
    QString opened;
    std::optional<ImageOrder> saved;
    {
        MainWindow window;
        connectSaving(window, saved);
        connect(&window, &MainWindow::folderChosen, this, [&](const QString& folder) { opened = folder; });
        window.setLastFolder(patient_);
        window.show();
        for (int i = 0; i < 2; ++i) {
            use(window, QKeySequence::Open, accept);
            use(window, QKeySequence::Save, accept);
        }
    }
    QCOMPARE(opened, accept ? patient_ + "/series" : QString());
    QCOMPARE(saved ? saved->file : QString(), accept ? patient_ + "/picture.png" : QString());
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

void TestFileDialogs::theDialogForSavingGoesWithItsImage() {
    MainWindow window;
    std::optional<ImageOrder> ordered;
    connectSaving(window, ordered);
    window.show();
    int seen = 0;
    QTimer::singleShot(0, &window, [&] {
        seen += qobject_cast<QFileDialog*>(QApplication::activeModalWidget()) != nullptr;
        window.menuActions().save->setEnabled(false);
    });
    for (QAction* action : window.findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QKeySequence::Save))
            action->trigger();  // comes back
    QCOMPARE(seen, 1);
    QVERIFY(!ordered);
}

/// The target is good for planning unless another is chosen.
void TestFileDialogs::anImageOfAnotherSizeIsOrderedWithItsTarget() {
    MainWindow window;
    std::optional<ImageOrder> ordered;
    connectSaving(window, ordered);
    window.show();
    QTimer::singleShot(0, &window, [&] {
        const auto* box = QApplication::activeModalWidget()->findChild<ImageSizeBox*>();
        QVERIFY(box && box->isVisible());
        box->findChild<QComboBox*>()->setCurrentIndex(2);
    });
    use(window, QKeySequence::Save, true);
    QVERIFY(ordered.has_value());
    QCOMPARE(ordered->file, patient_ + "/picture.png");
    QVERIFY(ordered->size == QSize(2000, 2000));
    QVERIFY((ordered->stop == StopRule{.levels = 8}));
    QVERIFY(ordered->annotate == Annotate::sides);
}

void TestFileDialogs::savingBeginsWithTheOffer() {
    MainWindow window;
    std::optional<ImageOrder> ordered;
    connectSaving(window, ordered, {.name = "Bone_A_2026-11-25", .folder = patient_});
    window.show();
    QString file;
    QTimer::singleShot(0, &window, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        file = dialog->selectedFiles().value(0);
        dialog->reject();
    });
    window.menuActions().save->trigger();
    QCOMPARE(file, patient_ + "/Bone_A_2026-11-25.png");
}

/// Saving begins in the documents folder, then in the last image's folder, also after other dialogs.
void TestFileDialogs::savingBeginsWhereTheLastImageIs() {
    QVERIFY(QDir().mkpath(home().filePath("Documents")));
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    window.show();
    window.menuActions().save->setEnabled(true);
    const auto beginsAt = [&] {
        QString folder;
        QTimer::singleShot(0, &window, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            folder = dialog->directory().absolutePath();
            dialog->reject();
        });
        window.menuActions().save->trigger();
        return folder;
    };
    QCOMPARE(beginsAt(), home().filePath("Documents"));
    use(window, QKeySequence::Save, true);
    use(window, QKeySequence::Open, false);
    QCOMPARE(beginsAt(), patient_);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestFileDialogs)
#include "file_dialogs_test.moc"
