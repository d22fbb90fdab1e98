#pragma once
/// Saves the image on the screen into a file, as it is at that moment.

#include <QObject>
#include <QString>
#include <optional>

#include "render/base/result.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

class RenderBridge;

class ImageSaver : public QObject {
    Q_OBJECT

  public:
    /// Saves images of `bridge`, which must outlive this.
    explicit ImageSaver(RenderBridge& bridge) : bridge_(bridge) {}

  public slots:
    /// Writes the image on the screen, with the samples that it has by then, and with `annotations` over it, if there
    /// are any. The file name extension chooses the format: ".exr" or ".png". Ends with saved() or failed(), the
    /// latter also if another image has taken its place.
    void save(const QString& file, const std::optional<ui::Annotations>& annotations = {});

  signals:
    void saved(const QString& file);
    void failed(const pdr::Error& error);

  private:
    RenderBridge& bridge_;
};

}  // namespace pdr::app
