#include "render/accuracy/shown_history.h"

#include <utility>

namespace pdr {

void ShownHistory::forgetErrors() {
    film_.forgetErrors();
    denoised_.forgetErrors();
    judged_ = 0;
}

void ShownHistory::add(double seconds, const FilmStatus& film, const ShownStatus& shown) {
    film_.add(seconds, film);
    if (shown.of == ErrorOf::denoised && std::exchange(judged_, shown.status.displayError) != shown.status.displayError)
        denoised_.add(seconds, shown.status);
}

std::vector<ErrorPoint> ShownHistory::points(ErrorOf of) const {
    return of == ErrorOf::denoised ? denoised_.points() : film_.points();
}

std::vector<QualityStep> ShownHistory::steps(ErrorOf of) const {
    if (of != ErrorOf::denoised)
        return film_.steps();
    std::vector<QualityStep> steps = denoised_.steps();
    const std::vector<QualityStep> films = film_.steps();
    for (std::size_t i = 0; i < steps.size() && i < films.size(); ++i)
        if (!steps[i].reached && !films[i].reached && films[i].seconds.value < steps[i].seconds.value)
            steps[i] = films[i];
    return steps;
}

}  // namespace pdr
