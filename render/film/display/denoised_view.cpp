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
    tone_.reset();
    const std::optional<DenoisedError> linear = judgement_->overAll(1);
    pays_ = !linear || smoothingPays(*linear, film.status());
}

Display DenoisedView::better(Display wanted) const {
    wanted.denoised = wanted.denoised && pays_;
    return wanted;
}

std::optional<DenoisedError> DenoisedView::error(const Tone& tone) {
    if (judgement_ && tone != tone_) {
        error_ = judgement_->overAll(tone);
        tone_ = tone;
    }
    return error_;
}

std::optional<DenoisedError> DenoisedView::errorOver(const Tile& part, const Tone& tone) const {
    return judgement_ ? judgement_->over(part, tone) : std::nullopt;
}

std::optional<LevelErrorMap> DenoisedView::errorMap(const Tone& tone) {
    const std::optional<DenoisedError> known = error(tone);
    return known ? std::optional(judgement_->errorMap(tone, known->levelsAtMost)) : std::nullopt;
}

std::vector<denoise::LostLine> DenoisedView::lostLines() const {
    return judgement_ ? judgement_->lostLines() : std::vector<denoise::LostLine>();
}

}  // namespace pdr
