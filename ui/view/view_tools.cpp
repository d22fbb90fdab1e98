#include "ui/view/view_tools.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace pdr::ui {

void ViewTools::add(ViewTool& tool) {
    tools_.insert(tools_.begin(), &tool);
    tool.setImage(image_);
    connect(&tool, &ViewTool::changed, this, &ViewTools::changed);
    connect(&tool, &ViewTool::activated, this, [this, &tool] { toFront(tool); });
    connect(&tool, &QObject::destroyed, this, [this, gone = &tool] { remove(gone); });
}

void ViewTools::remove(const ViewTool* tool) {
    std::erase(tools_, tool);
    std::erase_if(bindings_, [&](const Binding& binding) { return binding.tool == tool; });
    if (owner_ == tool)
        owner_ = nullptr;
}

void ViewTools::bind(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, ViewTool& tool) {
    const auto count = [](const Binding& binding) { return std::popcount(unsigned(binding.modifiers)); };
    bindings_.push_back({button, modifiers, &tool});
    std::ranges::stable_sort(bindings_, std::ranges::greater(), count);
    if (std::ranges::find(tools_, &tool) == tools_.end())
        add(tool);
}

void ViewTools::toFront(ViewTool& tool) {
    const auto place = std::ranges::find(tools_, &tool);
    std::rotate(tools_.begin(), place, place + 1);
    for (ViewTool* other : tools_)
        if (other != &tool)
            other->stepBack();
    emit changed();
}

/// Returns the tool whose gesture a press begins; null if there is none.
ViewTool* ViewTools::toolFor(const ViewPointer& pointer) const {
    for (ViewTool* tool : tools_)
        if (tool->takes(pointer))
            return tool;
    for (const Binding& binding : bindings_)
        if (binding.button == pointer.button && (pointer.modifiers & binding.modifiers) == binding.modifiers)
            return binding.tool;
    return nullptr;
}

bool ViewTools::take(const ViewPointer& pointer) const {
    return std::ranges::any_of(tools_, [&](const ViewTool* tool) { return tool->takes(pointer); });
}

void ViewTools::press(const ViewPointer& pointer) {
    if (owner_)
        return;
    owner_ = toolFor(pointer);
    leaveAllBut(owner_);
    if (owner_)
        owner_->press(pointer);
}

void ViewTools::move(const ViewPointer& pointer) {
    if (owner_)
        return owner_->move(pointer);
    const auto isUnder = [&](ViewTool* tool) { return pointer.held == Qt::NoButton && tool->hover(pointer); };
    const auto found = std::ranges::find_if(tools_, isUnder);
    leaveAllBut(found == tools_.end() ? nullptr : *found);
}

void ViewTools::release(const ViewPointer& pointer) {
    if (pointer.held != Qt::NoButton)
        return;
    if (ViewTool* ended = std::exchange(owner_, nullptr))
        ended->release(pointer);
}

void ViewTools::leave() {
    leaveAllBut(nullptr);
}

void ViewTools::leaveAllBut(const ViewTool* kept) {
    for (ViewTool* tool : tools_)
        if (tool != kept)
            tool->leave();
}

bool ViewTools::wheel(const ViewPointer& pointer, double clicks) {
    return std::ranges::any_of(tools_, [&](ViewTool* tool) { return tool->wheel(pointer, clicks); });
}

bool ViewTools::key(const QKeyEvent& event) {
    return std::ranges::any_of(tools_, [&](ViewTool* tool) { return tool->key(event); });
}

bool ViewTools::cancel() {
    return std::ranges::any_of(tools_, [](ViewTool* tool) { return tool->cancel(); });
}

Qt::CursorShape ViewTools::cursor() const {
    for (const ViewTool* tool : tools_)
        if (const auto shape = tool->cursor())
            return *shape;
    return Qt::ArrowCursor;
}

void ViewTools::setImage(const ImagePlace& image) {
    image_ = image;
    for (ViewTool* tool : tools_)
        tool->setImage(image);
}

void ViewTools::paint(QPainter& painter) const {
    for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool) {
        painter.save();
        (*tool)->paint(painter, image_);
        painter.restore();
    }
}

}  // namespace pdr::ui
