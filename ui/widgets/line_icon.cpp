#include "ui/widgets/line_icon.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>

#include "ui/widgets/line_drawing.h"

namespace pdr::ui {
namespace {

struct Drawing {
    const char* name;
    const char* lines;
    const char* areas = "";
    const char* linesOn = nullptr;  ///< the lines while the action is checked; null: the same lines
};

/// What cutting is shown by, as an action and as a panel.
constexpr const char* kScissors = "O 6 6.5 2.5 O 6 17.5 2.5 M 8.2 7.8 L 20 16.5 M 8.2 16.2 L 20 7.5";

/// The drawings, on a square of 24 x 24 units; see drawn().
constexpr Drawing kDrawings[] = {
    {"firstView", "M 12 3 L 20 7.5 L 20 16.5 L 12 21 L 4 16.5 L 4 7.5 Z M 4 7.5 L 12 12 L 20 7.5 M 12 12 L 12 21"},
    {"greyWindow", "O 12 12 8", "M 12 4 C 16.4 4 20 7.6 20 12 C 20 16.4 16.4 20 12 20 Z"},
    {"crosshair", "O 12 12 5.5 M 12 2.5 L 12 9.5 M 12 14.5 L 12 21.5 M 2.5 12 L 9.5 12 M 14.5 12 L 21.5 12"},
    {"distance",
     "M 5 19 L 19 5 M 2.5 16.5 L 7.5 21.5 M 16.5 2.5 L 21.5 7.5 M 8.2 13.8 L 10.2 15.8 M 13.8 8.2 L 15.8 10.2"},
    {"angle", "M 20 19 L 4 19 L 15 5 M 12 19 C 12 16.2 10.7 14.2 8.8 12.9"},
    {"cutHandles", kScissors},
    {"pause", "M 8.5 5 L 8.5 19 M 15.5 5 L 15.5 19", "", "M 8 5 L 19 12 L 8 19 Z"},
    {"save", "M 12 4 L 12 14.5 M 7.5 10.5 L 12 15 L 16.5 10.5 M 4 16 L 4 20 L 20 20 L 20 16"},
    {"alone", "M 4 9 L 4 4 L 9 4 M 15 4 L 20 4 L 20 9 M 20 15 L 20 20 L 15 20 M 9 20 L 4 20 L 4 15"},
    {"LookPanel", "R 4 4 6.5 6.5 R 13.5 4 6.5 6.5 R 4 13.5 6.5 6.5 R 13.5 13.5 6.5 6.5"},
    {"TissuePanel", "M 4 3.5 L 4 20 L 20.5 20 M 7 17 C 11 17 10 7 13.5 7 C 16.5 7 15.5 13 20 13"},
    {"LightPanel",
     "O 12 12 4 M 12 2.5 L 12 5 M 12 19 L 12 21.5 M 2.5 12 L 5 12 M 19 12 L 21.5 12 "
     "M 5.3 5.3 L 7 7 M 17 17 L 18.7 18.7 M 5.3 18.7 L 7 17 M 17 7 L 18.7 5.3"},
    {"CameraPanel", "R 3 7 18 12.5 O 12 13 3.5 M 8.5 7 L 10 4.5 L 14 4.5 L 15.5 7"},
    {"CutPanel", kScissors},
    {"MeasurementsPanel", "R 2.5 8 19 8 M 6.5 8 L 6.5 11 M 10.2 8 L 10.2 12.5 M 13.8 8 L 13.8 11 M 17.5 8 L 17.5 12.5"},
    {"PartsPanel",
     "M 11 5 C 5 4 3 9 3.5 14 C 4 19 8 20 10 18 C 11.5 16.5 11 9 11 5 Z "
     "M 13 5 C 19 4 21 9 20.5 14 C 20 19 16 20 14 18 C 12.5 16.5 13 9 13 5 Z",
     "M 13 5 C 19 4 21 9 20.5 14 C 20 19 16 20 14 18 C 12.5 16.5 13 9 13 5 Z"},
    {"RenderingPanel", "M 4 6 L 20 6 M 4 12 L 20 12 M 4 18 L 20 18", "O 9 6 2.4 O 15.5 12 2.4 O 7.5 18 2.4"},
    {"panel", "R 4 5 16 14 M 4 9.5 L 20 9.5"},
};

const Drawing* find(const QString& name) {
    for (const Drawing& drawing : kDrawings)
        if (name == drawing.name)
            return &drawing;
    return nullptr;
}

/// Paints a drawing at the size and in the colour that are current.
class LineIconEngine : public QIconEngine {
  public:
    explicit LineIconEngine(const Drawing& drawing) : drawing_(drawing) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        constexpr double kUnits = 24, kPen = 1.7;
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const QColor colour = QGuiApplication::palette().color(group, QPalette::ButtonText);
        const bool on = state == QIcon::On && drawing_.linesOn;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / kUnits, rect.height() / kUnits);
        painter->strokePath(drawn(on ? drawing_.linesOn : drawing_.lines),
                            QPen(colour, kPen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->fillPath(drawn(drawing_.areas), colour);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, pixmap.rect(), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new LineIconEngine(*this); }

  private:
    const Drawing& drawing_;
};

}  // namespace

bool hasLineIcon(const QString& name) {
    return find(name);
}

QIcon lineIcon(const QString& name) {
    const Drawing* drawing = find(name);
    return QIcon(new LineIconEngine(drawing ? *drawing : *find("panel")));
}

}  // namespace pdr::ui
