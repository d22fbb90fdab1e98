/// The gallery of looks: what it offers, collapses, shows and says.

#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "ui/looks/look_panel.h"

using namespace pdr::ui;

namespace {

const QList<LookCard> kLooks{{"Bone", "Bones", "Soft tissue is not shown.", ""},
                             {"Heart and great vessels", "Chest", "Fat is not shown.", ""},
                             {"Lung vessels", "Lungs", "", "no lungs are in this scan"},
                             {"Thin bone", "Bones", "", ""}};

QToolButton* named(const QWidget& within, const QString& name) {
    for (QToolButton* button : within.findChildren<QToolButton*>())
        if (button->accessibleName() == name && button->parentWidget())
            return button;
    return nullptr;
}

bool shows(const QWidget& within, const QString& name) {
    const QToolButton* button = named(within, name);
    return button && button->isVisibleTo(&within);
}

}  // namespace

class LookGalleryTest : public QObject {
    Q_OBJECT

  private slots:
    void groupsAreFoldedButThatOfTheLookShown() {
        LookGallery gallery;
        gallery.setLooks(kLooks);
        QVERIFY(!shows(gallery, "Look Bone") && !shows(gallery, "Look Heart and great vessels"));
        gallery.setLook(1);
        QVERIFY(!shows(gallery, "Look Bone") && shows(gallery, "Look Heart and great vessels"));
        QVERIFY(named(gallery, "Look Heart and great vessels")->isChecked());
        gallery.setLook(-1);
        QVERIFY(!named(gallery, "Look Heart and great vessels")->isChecked());
    }

    void aHeadingFoldsAndStaysAsTheHandLeftIt() {
        LookGallery gallery;
        gallery.setLooks(kLooks);
        named(gallery, "Looks: Bones")->click();
        QVERIFY(shows(gallery, "Look Bone") && shows(gallery, "Look Thin bone"));
        named(gallery, "Looks: Bones")->click();
        gallery.setLook(0);  // its group was folded by hand
        QVERIFY(!shows(gallery, "Look Bone"));
    }

    void whatMakesNoSenseStandsApartAndSaysWhy() {
        LookGallery gallery;
        gallery.setLooks(kLooks);
        QVERIFY(!named(gallery, "Looks: Lungs"));
        QVERIFY(!shows(gallery, "Look Lung vessels"));
        named(gallery, "Looks: Not for this scan")->click();
        QVERIFY(shows(gallery, "Look Lung vessels"));
        QVERIFY(named(gallery, "Look Lung vessels")->toolTip().contains("no lungs are in this scan"));
        QSignalSpy chosen(&gallery, &LookGallery::lookChosen);
        named(gallery, "Look Lung vessels")->click();  // nothing is impossible
        QCOMPARE(chosen.first().first().toInt(), 2);
    }

    /// Another scan is opened, and another look will be shown of it.
    void whatWasShownBeforeUnfoldsNothing() {
        LookGallery gallery;
        gallery.setLooks(kLooks);
        gallery.setLook(0);
        QList<LookCard> others = kLooks;
        others[0].unsuited = "there is contrast in the blood";
        gallery.setLooks(others);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the buttons before
        QVERIFY(named(gallery, "Look Bone")->isChecked() && !shows(gallery, "Look Bone"));
        gallery.setLook(0);
        QVERIFY(shows(gallery, "Look Bone"));
    }

    void imagesStayWithTheirLooks() {
        LookGallery gallery;
        gallery.setLooks(kLooks);
        QImage red(96, 96, QImage::Format_RGB32);
        red.fill(Qt::red);
        gallery.setImage(1, red);
        gallery.setImage(7, red);
        QList<LookCard> others{kLooks[1], kLooks[0]};
        gallery.setLooks(others);
        const QIcon icon = named(gallery, "Look Heart and great vessels")->icon();
        QCOMPARE(icon.pixmap(96).toImage().pixelColor(40, 40), QColor(Qt::red));
        QVERIFY(named(gallery, "Look Bone")->icon().isNull());
    }

    void thePanelSaysWhatTheLookDoesNotShow() {
        LookPanel panel;
        const auto says = [&](const QString& text) {
            for (const QLabel* label : panel.findChildren<QLabel*>())
                if (label->text() == text && label->isVisibleTo(&panel))
                    return true;
            return false;
        };
        panel.setDoesNotShow("Soft tissue is not shown.");
        QVERIFY(says("Soft tissue is not shown."));
        panel.setDoesNotShow("Fat is not shown.");
        QVERIFY(says("Fat is not shown.") && !says("Soft tissue is not shown."));
        panel.setDoesNotShow("");
        QVERIFY(!says("Fat is not shown."));
    }

    /// A smaller part would be useless: the panel asks for the height of one row of thumbnails, and scrolls in less.
    void aRowOfTheGalleryIsAlwaysThere() {
        LookPanel panel;
        panel.gallery().setLooks(kLooks);
        panel.setLook(0);
        panel.setDoesNotShow("Soft tissue is not shown, and bone below 230 HU is faint.");
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        for (const int height : {600, 100, 600}) {
            panel.resize(280, height);
            QCoreApplication::processEvents();
            QVERIFY(panel.gallery().isVisible());
            QVERIFY(panel.gallery().parentWidget()->height() >= LookGallery::kImage);
        }
    }

    void theKeyboardReachesEveryLookBeforeTheRest() {
        LookPanel panel;
        panel.gallery().setLooks(kLooks);
        panel.setLook(0);
        panel.resize(280, 600);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QStringList reached;
        for (QWidget* widget = panel.nextInFocusChain(); widget != &panel; widget = widget->nextInFocusChain())
            if ((widget->focusPolicy() & Qt::TabFocus) && widget->isVisible())
                reached << widget->accessibleName();
        const auto at = [&](const char* name) { return reached.indexOf(name); };
        QVERIFY2(at("Look Bone") >= 0 && at("Look Bone") < at("Brightness"), qPrintable(reached.join(", ")));
        QVERIFY(at("Looks: Chest") >= 0 && at("Looks: Chest") < at("Brightness"));
    }
};

QTEST_MAIN(LookGalleryTest)
#include "look_gallery_test.moc"
