#include "app/presenters/mark_tools.h"

#include <QCoreApplication>

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Marks)
};

struct Tool {
    MeasureKind kind;
    const char* name;  ///< the name of its action, under which its key is saved
    QKeySequence key;
    QString text, button, tip;
};

std::vector<Tool> tools() {
    return {
        {MeasureKind::distance, "distance", Qt::Key_M, Texts::tr("&Distance"), Texts::tr("Distance"),
         Texts::tr("Click two places of a slice or of the image. They move to the edge of a structure; Alt: they "
                   "stay.")},
        {MeasureKind::angle, "angle", Qt::Key_A, Texts::tr("&Angle"), Texts::tr("Angle"),
         Texts::tr("Click three places of a slice or of the image: the angle at the second.")},
        {MeasureKind::lines, "lines", Qt::SHIFT | Qt::Key_A, Texts::tr("Angle of two lines"), Texts::tr("Two lines"),
         Texts::tr("Click both ends of a line, then of another: the angle between their directions.")},
        {MeasureKind::point, "label", Qt::Key_I, Texts::tr("Label"), Texts::tr("Label"),
         Texts::tr("Click a place, and type what it is. The list shows its value.")},
        {MeasureKind::ball, "ball", Qt::Key_O, Texts::tr("Mean in a ball"), Texts::tr("Ball"),
         Texts::tr("Click the middle of a ball, then a place on its surface: the mean of the values inside.")},
        {MeasureKind::ellipse, "ellipse", Qt::SHIFT | Qt::Key_O, Texts::tr("Mean in an ellipse"), Texts::tr("Ellipse"),
         Texts::tr("Click the middle of an ellipse on a slice, the end of one half axis, then how far the other "
                   "reaches: the mean of the values inside, and the area.")},
        {MeasureKind::polygon, "polygon", Qt::SHIFT | Qt::Key_M, Texts::tr("Area of a polygon"), Texts::tr("Polygon"),
         Texts::tr("Click the corners of a polygon on a slice. Enter, a double click or a click on the first corner "
                   "closes it, Backspace takes the last corner back.")},
    };
}

}  // namespace

MarkTools::MarkTools(QMenu& menu, ui::MarksPanel& panel, QWidget& window) {
    menu.addSeparator();
    for (const Tool& tool : tools()) {
        QAction* action = actions_[std::size_t(tool.kind)] = menu.addAction(tool.text, tool.key);
        action->setCheckable(true);
        action->setObjectName(tool.name);
        action->setIconText(tool.button);
        action->setToolTip(tool.tip);
        window.addAction(action);  // so that its key works while the menu bar is hidden
        panel.addTool(action);
        connect(action, &QAction::triggered, this,
                [this, kind = tool.kind](bool drawing) { emit chosen(drawing ? std::optional(kind) : std::nullopt); });
    }
}

void MarkTools::setEnabled(bool enabled) {
    for (QAction* action : actions_)
        action->setEnabled(enabled);
}

void MarkTools::setDrawing(const std::optional<MeasureKind>& kind) {
    for (std::size_t i = 0; i < actions_.size(); ++i)
        actions_[i]->setChecked(kind && std::size_t(*kind) == i);
}

}  // namespace pdr::app
