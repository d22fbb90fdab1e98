#include "app/output/judged_image.h"

#include <utility>

#include "render/film/file/image_format.h"

namespace pdr::app {

JudgedImage::JudgedImage(const Film& film, const Scene& scene, const Display& wanted, Rendered rendered,
                         const std::stop_token& stop, DenoisedView* onScreen)
    : film_(film),
      scene_(scene),
      wanted_(wanted.withDenoised(wanted.denoised && canBeDenoised(scene))),
      rendered_(std::move(rendered)),
      denoiser_(onScreen ? onScreen : &own_) {
    if (wanted_.denoised && denoiser_->isStale(film.samplesPerPixel()))
        denoiser_->judge(film, film.samplesPerPixel(), stop);
    denoised_ = denoiser_->better(wanted_).denoised;
}

ShownStatus JudgedImage::shown() {
    return shownStatus(rendered_.status, denoised_, error());
}

std::vector<Bias> JudgedImage::biases() {
    BiasFacts facts = biasFactsOf(scene_, rendered_);
    facts.isDenoised = denoised_;
    if (denoised_)
        facts.denoised = error();
    return pdr::biases(facts);
}

Result<void> JudgedImage::write(const std::filesystem::path& file, const PaintOver& paintOver,
                                const std::stop_token& stop) {
    const Provenance provenance = provenanceOf(scene_, rendered_);
    if (imageFormat(file) == ImageFormat::exr)
        return writeExr(film_, provenance, file, stop);
    return writePng(film_, wanted_, *denoiser_, provenance, file, paintOver, stop);
}

}  // namespace pdr::app
