/// The layouts of the views in the middle of the window.

#include <QSignalSpy>
#include <QTest>

#include "ui/window/view_grid.h"

namespace pdr::ui {
namespace {

struct Four {
    QWidget* image = new QWidget;
    std::array<QWidget*, 3> slices{new QWidget, new QWidget, new QWidget};
    ViewGrid grid{image};

    Four() {
        for (QWidget* slice : slices)
            grid.addSlice(slice);
        grid.resize(800, 600);
        grid.show();
    }

    int shown() const { return int(image->isVisible()) + int(std::ranges::count_if(slices, &QWidget::isVisible)); }
    void layOut(ViewLayout layout) {
        grid.setLayout(layout);
        QCoreApplication::processEvents();
    }
};

}  // namespace

class ViewGridTest : public QObject {
    Q_OBJECT

  private slots:
    void atFirstTheImageIsAlone() {
        Four four;
        QCOMPARE(four.shown(), 1);
        QVERIFY(four.image->isVisible() && four.image->width() == 800 && !four.grid.showsSlices());
    }

    void besideTheImageIsTheLargest() {
        Four four;
        four.layOut(ViewLayout::beside);
        QCOMPARE(four.shown(), 4);
        for (const QWidget* slice : four.slices) {
            QVERIFY(slice->x() > four.image->x() && slice->width() < four.image->width());
            QVERIFY(slice->height() < four.image->height() / 2);
        }
        QVERIFY(four.slices[0]->y() < four.slices[1]->y() && four.slices[1]->y() < four.slices[2]->y());
    }

    void quartersAreOfOneSize() {
        Four four;
        four.layOut(ViewLayout::quarters);
        QCOMPARE(four.shown(), 4);
        for (const QWidget* slice : four.slices)
            QVERIFY(std::abs(slice->width() - four.image->width()) <= 2 &&
                    std::abs(slice->height() - four.image->height()) <= 2);
        QVERIFY(four.image->x() > 0 && four.image->y() == 0);  // above, to the right
    }

    void oneViewAloneAndBack() {
        Four four;
        four.layOut(ViewLayout::quarters);
        four.grid.toggleAlone(four.slices[1]);
        QCOMPARE(four.shown(), 1);
        QVERIFY(four.slices[1]->isVisible() && four.grid.showsSlices());
        four.grid.toggleAlone(four.slices[1]);
        QCOMPARE(four.shown(), 4);
        four.grid.toggleAlone(four.image);
        QVERIFY(!four.grid.showsSlices());
        four.layOut(ViewLayout::beside);
        QCOMPARE(four.shown(), 4);
    }

    void eachLayoutIsReportedOnce() {
        Four four;
        QSignalSpy changed(&four.grid, &ViewGrid::layoutChanged);
        four.layOut(ViewLayout::beside);
        four.layOut(ViewLayout::beside);
        four.layOut(ViewLayout::image);
        QCOMPARE(changed.size(), 2);
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::ViewGridTest)
#include "view_grid_test.moc"
