#pragma once
/// A tool that takes and counts all presses that no tool in front of it has taken.

#include "ui/view/view_tool.h"

namespace pdr::test {

class PressCounter : public ui::ViewTool {
  public:
    bool takes(const ui::ViewPointer&) const override { return true; }
    void press(const ui::ViewPointer& pointer) override { ++(pointer.twice ? doubleClicks : clicks); }

    int clicks = 0, doubleClicks = 0;
};

}  // namespace pdr::test
