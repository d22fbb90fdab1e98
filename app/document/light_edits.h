#pragma once
/// What the hand does to the lights, on the panel and on the picture, as edits of the document.

#include <QObject>
#include <QPointF>
#include <memory>

#include "app/document/document.h"
#include "render/scene/named_rig.h"

namespace pdr::app {

class LightEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` outlives it.
    explicit LightEdits(Document& document) : document_(document) {}

    Lighting lighting() const;

  public slots:
    /// One gesture is one step to undo.
    void setLighting(const pdr::Lighting& lighting, bool moving);
    /// That picture of surroundings instead of the rig; a step to undo. See litBy() in render/scene/sky_picture.h.
    void setSky(const std::shared_ptr<const pdr::EnvironmentImage>& picture);
    /// A drag on the picture since the last, in fractions of the view's height: turns all lights as a hand on their
    /// near side would.
    void turn(QPointF inHeights, bool moving);

  private:
    Document& document_;
};

}  // namespace pdr::app
