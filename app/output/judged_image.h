#pragma once
/// A film as an image that leaves the program, with all that is known of it: denoised where that is wanted and known to
/// be better. Window and command line write no other.

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
    /// Judges the denoised image where `wanted` asks for it and the scene allows it. `film` and `scene` outlive this,
    /// as does `onScreen`: what is known of the same film's denoised image there, which is judged anew where it is
    /// stale, so that screen and file say the same. Null: it is on no screen.
    JudgedImage(const Film& film, const Scene& scene, const Display& wanted, Rendered rendered,
                const std::stop_token& stop, SmoothedView* onScreen = nullptr);
    JudgedImage(const JudgedImage&) = delete;
    JudgedImage& operator=(const JudgedImage&) = delete;

    /// Whether its PNG files are denoised.
    bool denoised() const { return denoised_; }
    /// How good it is.
    ShownStatus shown();
    std::vector<Bias> biases();

    /// In the format that the name's end says, PNG or OpenEXR, with its provenance. `paintOver`: for PNG files. Errors:
    /// those of writePng() and writeExr().
    Result<void> write(const std::filesystem::path& file, const PaintOver& paintOver, const std::stop_token& stop);

  private:
    std::optional<SmoothedError> error() { return denoiser_->error(double(wanted_.exposure)); }

    const Film& film_;
    const Scene& scene_;
    Display wanted_;
    Rendered rendered_;
    SmoothedView own_;
    SmoothedView* denoiser_;
    bool denoised_ = false;
};

}  // namespace pdr::app
