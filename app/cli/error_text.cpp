#include "app/cli/error_text.h"

#include <cmath>
#include <cstdio>

#include "render/film/levels_text.h"

namespace pdr::app {
namespace {

std::string percentText(double fraction) {
    char text[32];
    const double percent = 100 * fraction;
    std::snprintf(text, sizeof text, percent < 10 ? "%.2g %%" : "%.0f %%", percent);
    return text;
}

std::string levelsClause(const FilmStatus& status, const char* verb) {
    if (!std::isfinite(status.displayError))
        return {};
    return "95 % of the tissue " + std::string(verb) + "within +-" + levelsText(status.displayError) +
           " of 255 grey levels";
}

std::string unknownSentence(const FilmStatus& status) {
    if (!(status.unseenShare > 0))
        return "The remaining error is not known.";
    const std::string most = std::to_string(std::llround(std::floor(1 / status.unseenShare)));
    if (status.meanLuminance > 0)
        return "The remaining error is not known: all samples of a pixel were alike so far. At most 1 in " + most +
               " is different.";
    return "The remaining error is not known: no light was seen so far. At most 1 in " + most + " samples brings some.";
}

}  // namespace

std::string errorText(const FilmStatus& status) {
    if (!std::isfinite(status.relativeError))
        return "error not known yet";
    const std::string levels = levelsClause(status, "");
    return levels + (levels.empty() ? "" : ", ") + "error " + percentText(status.relativeError);
}

std::string errorSentence(const FilmStatus& status) {
    if (!std::isfinite(status.relativeError))
        return unknownSentence(status);
    if (status.relativeError == 0)
        return "The image is without noise.";
    const std::string levels = levelsClause(status, "is ");
    return "The remaining error is " + percentText(status.relativeError) + " of the mean brightness" +
           (status.tissuePixels > 0 ? " of the tissue" : "") + (levels.empty() ? "." : "; " + levels + ".");
}

}  // namespace pdr::app
