#pragma once
/// What is painted over an image so that it can be read wherever it goes: the patient's sides, an orientation cube, a
/// scale bar, what is shown and how, and that it is not for diagnostic use. The screen, files, the clipboard and the
/// command line use the same painter; it needs Qt's fonts (QGuiApplication) but no widget.

#include <QPainter>
#include <QStringList>
#include <cstdint>
#include <vector>

#include "render/scene/camera.h"

namespace pdr::ui {

/// The annotations of an image that leaves the program. OpenEXR files carry none.
enum class Annotate {
    none,    ///< no annotations
    sides,   ///< all but the patient's identity
    patient  ///< also the patient's identity
};

/// The annotations of one image.
struct Annotations {
    Camera camera;        ///< camera of the image, from which letters, cube and scale bar are painted
    QStringList patient;  ///< upper left corner, a line each; empty: no patient is named
    QStringList texts;    ///< lower left corner, a line each: look, part, cut, state of the image
    bool cube = true;     ///< whether an orientation cube is painted; a slice needs none
};

/// Paints the annotations over an image that fills `size` from (0, 0), in the painter's font. The last line in the
/// lower left corner is always "Not for diagnostic use". If the shorter side of `size` is less than 12 font heights,
/// only the orientation letters are painted; below 4 font heights nothing.
void paintAnnotations(QPainter& painter, const Annotations& annotations, const QSize& size);

/// Paints the annotations over pixels of 4 bytes each, row by row from the top, in a font size that suits `size`. Any
/// thread may call it.
void annotate(const Annotations& annotations, ivec2 size, std::vector<std::uint8_t>& rgba);

}  // namespace pdr::ui
