#include "app/remote/drip_watch.h"

namespace pdr::remote {

bool DripWatch::tooSlow(std::chrono::milliseconds now, std::int64_t received, std::int64_t messages, bool inMessage) {
    const bool another = messages != messagesThen_;
    const bool over = watching_ && now - since_ >= limits_.window;
    const bool enough = (received - receivedThen_) * 1000 >= limits_.bytesPerSecond * limits_.window.count();
    if (watching_ && inMessage && !another && over && !enough)
        return true;
    if (!watching_ || another || over || !inMessage) {
        watching_ = inMessage;
        since_ = now;
        receivedThen_ = received;
        messagesThen_ = messages;
    }
    return false;
}

}  // namespace pdr::remote
