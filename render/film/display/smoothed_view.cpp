#include "render/film/display/smoothed_view.h"

#include <utility>

namespace pdr {

void SmoothedView::judge(const Film& film, std::uint64_t samples, const std::stop_token& stop) {
    std::optional<SmoothingJudgement> judgement = SmoothingJudgement::of(film, stop);
    if (stop.stop_requested())
        return;
    judgedSamples_ = samples;
    if (!judgement)
        return;
    judgement_ = std::move(judgement);
    exposure_ = 0;
    const std::optional<SmoothedError> linear = judgement_->overAll(1);
    pays_ = !linear || smoothingPays(*linear, film.status());
}

Display SmoothedView::better(Display wanted) const {
    wanted.smoothed = wanted.smoothed && pays_;
    return wanted;
}

std::optional<SmoothedError> SmoothedView::error(double exposure) {
    if (judgement_ && exposure != exposure_) {
        error_ = judgement_->overAll(exposure);
        exposure_ = exposure;
    }
    return error_;
}

std::optional<SmoothedError> SmoothedView::errorOver(const Tile& part, double exposure) const {
    return judgement_ ? judgement_->over(part, exposure) : std::nullopt;
}

std::optional<LevelErrorMap> SmoothedView::errorMap(double exposure) {
    const std::optional<SmoothedError> known = error(exposure);
    return known ? std::optional(judgement_->errorMap(exposure, known->levelsAtMost)) : std::nullopt;
}

std::vector<denoise::LostLine> SmoothedView::lostLines() const {
    return judgement_ ? judgement_->lostLines() : std::vector<denoise::LostLine>();
}

}  // namespace pdr
