#pragma once
/// Edits of the lights by the user, on the panel and on the image, as edits of the document.

#include <QObject>
#include <QPointF>
#include <memory>

#include "app/document/document.h"
#include "render/scene/named_rig.h"

namespace pdr::app {

class LightEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` must outlive this object.
    explicit LightEdits(Document& document) : document_(document) {}

    Lighting lighting() const;

  public slots:
    /// Sets the lighting. One gesture is one step to undo.
    void setLighting(const pdr::Lighting& lighting, bool moving);
    /// Lights the volume with the environment image `image` instead of the rig. One step to undo. See litBy() in
    /// render/scene/sky_image.h.
    void setSky(const std::shared_ptr<const pdr::EnvironmentImage>& image);
    /// Turns all lights by a drag on the image since the last call, in fractions of the view's height, as if the
    /// pointer pulled at their near side.
    void turn(QPointF inHeights, bool moving);

  private:
    Document& document_;
};

}  // namespace pdr::app
