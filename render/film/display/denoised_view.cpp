#include "render/film/display/denoised_view.h"

#include <utility>

namespace pdr {

void DenoisedView::judge(const Film& film, std::uint64_t samples, const std::stop_token& stop,
                         const HalfSmoother& smoother) {
    std::optional<SmoothingJudgement> judgement = SmoothingJudgement::of(film, smoother, stop);
    if (stop.stop_requested())
        return;
    judgedSamples_ = samples;
    if (!judgement)
        return;
    judgement_ = std::move(judgement);
    exposure_ = 0;
    const std::optional<DenoisedError> linear = judgement_->overAll(1);
    pays_ = !linear || smoothingPays(*linear, film.status());
}

Display DenoisedView::better(Display wanted) const {
    wanted.denoised = wanted.denoised && pays_;
    return wanted;
}

std::optional<DenoisedError> DenoisedView::error(double exposure) {
    if (judgement_ && exposure != exposure_) {
        error_ = judgement_->overAll(exposure);
        exposure_ = exposure;
    }
    return error_;
}

std::optional<DenoisedError> DenoisedView::errorOver(const Tile& part, double exposure) const {
    return judgement_ ? judgement_->over(part, exposure) : std::nullopt;
}

std::optional<LevelErrorMap> DenoisedView::errorMap(double exposure) {
    const std::optional<DenoisedError> known = error(exposure);
    return known ? std::optional(judgement_->errorMap(exposure, known->levelsAtMost)) : std::nullopt;
}

std::vector<denoise::LostLine> DenoisedView::lostLines() const {
    return judgement_ ? judgement_->lostLines() : std::vector<denoise::LostLine>();
}

}  // namespace pdr
