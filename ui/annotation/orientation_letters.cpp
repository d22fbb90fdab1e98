#include "ui/annotation/orientation_letters.h"

namespace pdr::ui {

EdgeLetters edgeLetters(const Camera& camera) {
    return pdr::edgeLetters(camera.right(), -camera.imageUp());
}

}  // namespace pdr::ui
