/// The dispatch of a view's events to its tools: who is asked, who has the pointer, and in which order they paint.

#include "ui/view/view_tools.h"

#include <QImage>
#include <QTest>

#include "ui/view/drag_tool.h"

namespace pdr::ui {

/// A tool that writes down what happens to it, as "name event".
class Recorder : public ViewTool {
  public:
    Recorder(QString name, QStringList& record) : name_(std::move(name)), record_(record) {}

    bool takes(const ViewPointer&) const override { return active; }
    void press(const ViewPointer&) override { note("press"); }
    void move(const ViewPointer&) override { note("move"); }
    void release(const ViewPointer&) override { note("release"); }
    bool hover(const ViewPointer&) override {
        note("hover");
        return active;
    }
    void leave() override { note("leave"); }
    bool wheel(const ViewPointer&, double) override { return note("wheel"), active; }
    bool key(const QKeyEvent&) override { return note("key"), active; }
    bool cancel() override { return note("cancel"), active; }
    std::optional<Qt::CursorShape> cursor() const override {
        return active ? std::optional(Qt::CrossCursor) : std::nullopt;
    }
    void paint(QPainter&, const ImagePlace&) const override { note("paint"); }

    bool active = false;

  private:
    void note(const char* event) const { record_ << name_ + " " + event; }

    QString name_;
    QStringList& record_;
};

/// Two tools, `front` before `back`, and a third that a left press with Shift begins if neither takes it.
struct Bench {
    Bench() {
        tools.bind(Qt::LeftButton, Qt::ShiftModifier, bound);
        tools.add(back);
        tools.add(front);
        record.clear();
    }
    /// Returns what has happened since the last call.
    QStringList told() { return std::exchange(record, {}); }
    static ViewPointer pointer(Qt::MouseButton button, Qt::MouseButtons held, Qt::KeyboardModifiers modifiers = {}) {
        return {{10, 20}, button, held, modifiers, false, {{200, 100}, QRectF(0, 0, 200, 100), Camera{}}};
    }
    void press(Qt::KeyboardModifiers modifiers = {}) {
        tools.press(pointer(Qt::LeftButton, Qt::LeftButton, modifiers));
    }
    void move(Qt::MouseButtons held) { tools.move(pointer(Qt::NoButton, held)); }
    void release(Qt::MouseButtons held = {}) { tools.release(pointer(Qt::LeftButton, held)); }

    QStringList record;
    Recorder bound{"bound", record}, back{"back", record}, front{"front", record};
    ViewTools tools;
};

class TestViewTools : public QObject {
    Q_OBJECT

  private slots:
    void theFrontToolThatTakesAPressHasThePointer() {
        Bench bench;
        bench.front.active = bench.back.active = true;
        bench.press();
        QCOMPARE(bench.told(), QStringList({"back leave", "bound leave", "front press"}));
        bench.move(Qt::LeftButton);
        bench.press();  // of another button
        bench.release(Qt::RightButton);
        QCOMPARE(bench.told(), QStringList{"front move"});
        QVERIFY(bench.tools.inGesture());
        bench.release();
        QCOMPARE(bench.told(), QStringList{"front release"});
        QVERIFY(!bench.tools.inGesture());
    }

    void anActivatedToolComesToTheFront() {
        Bench bench;
        bench.front.active = bench.back.active = true;
        emit bench.back.activated();
        bench.press();
        QCOMPARE(bench.told().last(), QString("back press"));
    }

    void aPressThatNoToolTakesGoesByButtonAndModifiers() {
        Bench bench;
        bench.press();
        QVERIFY(!bench.tools.inGesture());
        bench.press(Qt::ShiftModifier | Qt::AltModifier);
        QCOMPARE(bench.told().last(), QString("bound press"));
        bench.release();
        bench.back.active = true;
        bench.press(Qt::ShiftModifier);
        QCOMPARE(bench.told().last(), QString("back press"));
    }

    void aToolUnderThePointerHidesThoseBehind() {
        Bench bench;
        bench.back.active = true;
        bench.move({});
        QCOMPARE(bench.told(), QStringList({"front hover", "back hover", "front leave", "bound leave"}));
        bench.move(Qt::RightButton);  // a button that begins nothing
        QCOMPARE(bench.told(), QStringList({"front leave", "back leave", "bound leave"}));
    }

    void wheelKeysAndEscapeEndAtTheFirstThatUsesThem() {
        Bench bench;
        bench.back.active = true;
        const QKeyEvent key(QEvent::KeyPress, Qt::Key_M, {});
        QVERIFY(bench.tools.wheel(Bench::pointer(Qt::NoButton, {}), 1));
        QVERIFY(bench.tools.key(key));
        QVERIFY(bench.tools.cancel());
        QCOMPARE(bench.told(),
                 QStringList({"front wheel", "back wheel", "front key", "back key", "front cancel", "back cancel"}));
        bench.back.active = false;
        QVERIFY(!bench.tools.key(key) && !bench.tools.cancel());
    }

    void theCursorIsThatOfTheFrontToolWithOne() {
        Bench bench;
        QCOMPARE(bench.tools.cursor(), Qt::ArrowCursor);
        bench.back.active = true;
        QCOMPARE(bench.tools.cursor(), Qt::CrossCursor);
    }

    void theFrontToolIsPaintedLast() {
        Bench bench;
        QImage image(20, 10, QImage::Format_RGB32);
        QPainter painter(&image);
        bench.tools.paint(painter);
        QCOMPARE(bench.told(), QStringList({"bound paint", "back paint", "front paint"}));
    }

    /// Tools see places as fractions, whatever the view's size.
    void aDragIsMeasuredInHeightsAndAClickInFractions() {
        DragTool tool(kTremble);
        QPointF total, step, place;
        int drags = 0, ends = 0;
        QObject::connect(&tool, &DragTool::dragged, [&](QPointF all, QPointF last, bool moving) {
            total = all;
            step = last;
            ++(moving ? drags : ends);
        });
        QObject::connect(&tool, &DragTool::clicked, [&](QPointF at) { place = at; });
        ViewPointer pointer = Bench::pointer(Qt::LeftButton, Qt::LeftButton);
        tool.press(pointer);
        pointer.at = {12, 20};
        tool.move(pointer);
        tool.release(pointer);
        QCOMPARE(drags + ends, 0);
        QCOMPARE(place, QPointF(0.06, 0.2));
        tool.press(pointer);
        pointer.at = {22, 20};
        tool.move(pointer);
        pointer.at = {22, 40};
        tool.move(pointer);
        QCOMPARE(total, QPointF(0.1, 0.2));
        QCOMPARE(step, QPointF(0, 0.2));
        tool.release(pointer);
        QCOMPARE(drags, 2);
        QCOMPARE(ends, 1);
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestViewTools)
#include "view_tools_test.moc"
