#include "render/film/error/shown_status.h"

namespace pdr {
namespace {

constexpr double kSigmas = 1.645;  ///< standard deviations of a one-sided 95 %

}  // namespace

ShownStatus shownStatus(const FilmStatus& film, bool denoised, const std::optional<DenoisedError>& error) {
    if (!denoised)
        return {film, ErrorOf::film};
    if (!error || film.tissuePixels == 0)
        return {film, ErrorOf::beforeDenoising};
    ShownStatus shown{film, ErrorOf::denoised};
    shown.status.displayError = error->levelsAtMost;
    shown.status.displayErrorSpread = (error->levelsAtMost - error->levels) / kSigmas;
    shown.status.gain = 0;
    return shown;
}

}  // namespace pdr
