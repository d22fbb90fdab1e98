#include "ui/nodes/split_box.h"

#include <array>

namespace pdr::ui {

/// The splits of the entries, in their order.
static constexpr std::array<std::optional<Split>, 3> kSplits{std::nullopt, Split::tiles, Split::samples};

SplitBox::SplitBox(QWidget* parent) : QComboBox(parent) {
    addItems({tr("Shared out by cost"), tr("Always tiles"), tr("Always samples")});
    setAccessibleName(tr("How nodes share the work"));
    setToolTip(
        tr("Tiles: each node renders a part of the image. Samples: each renders the whole image, a block of samples at "
           "a time, which is sooner where tiles would be too small."));
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image
    connect(this, &QComboBox::activated, this, [this](int entry) { emit splitRequested(kSplits[std::size_t(entry)]); });
}

void SplitBox::setSplit(std::optional<Split> split) {
    setCurrentIndex(!split ? 0 : *split == Split::tiles ? 1 : 2);
}

}  // namespace pdr::ui
