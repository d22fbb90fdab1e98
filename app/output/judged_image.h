#pragma once
/// A film as an image file with all that is known of it: denoised if that is requested and known to be better. Window
/// and command line write all images through this class.

#include <filesystem>
#include <stop_token>
#include <vector>

#include "app/output/provenance.h"
#include "render/film/error/shown_status.h"
#include "render/film/file/image_file.h"
#include "render/scene/scene.h"

namespace pdr::app {

class JudgedImage {
  public:
    /// Judges the denoised image if `wanted` asks for denoising and the scene allows it. `film` and `scene` must
    /// outlive this object.
    /// `onScreen`: what is known of the denoised image of the same film on the screen; null: it is on no screen. It
    /// must outlive this object, and is judged anew if it is stale, so that screen and file agree.
    JudgedImage(const Film& film, const Scene& scene, const Display& wanted, Rendered rendered,
                const std::stop_token& stop, DenoisedView* onScreen = nullptr);
    JudgedImage(const JudgedImage&) = delete;
    JudgedImage& operator=(const JudgedImage&) = delete;

    /// Whether PNG files of the image are denoised.
    bool denoised() const { return denoised_; }
    /// Returns how good the image is.
    ShownStatus shown();
    std::vector<Bias> biases();

    /// Writes the image with its provenance, as PNG or OpenEXR by the file's extension. `paintOver`: for PNG files.
    /// Errors: those of writePng() and writeExr().
    Result<void> write(const std::filesystem::path& file, const PaintOver& paintOver, const std::stop_token& stop);

  private:
    std::optional<DenoisedError> error() { return denoiser_->error(wanted_); }

    const Film& film_;
    const Scene& scene_;
    Display wanted_;
    Rendered rendered_;
    DenoisedView own_;
    DenoisedView* denoiser_;
    bool denoised_ = false;
};

}  // namespace pdr::app
