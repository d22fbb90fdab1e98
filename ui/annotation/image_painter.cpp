#include "ui/annotation/image_painter.h"

#include <utility>

#include "ui/text/accuracy_text.h"

namespace pdr::ui {

std::function<PaintOver(const ShownStatus&)> imagePainter(std::optional<Annotations> annotations, double target) {
    return [annotations = std::move(annotations), target](const ShownStatus& shown) -> PaintOver {
        if (!annotations)
            return {};
        Annotations all = *annotations;
        all.texts << previewText(shown, target);
        return [all = std::move(all)](ivec2 size, std::vector<std::uint8_t>& rgba) { annotate(all, size, rgba); };
    };
}

}  // namespace pdr::ui
