#pragma once
/// What a render node says of itself.

#include <optional>

#include "app/node/node_options.h"
#include "app/wire/messages.h"
#include "render/device/device.h"

namespace pdr::node {

/// Returns the first message to coordinators. Renders the reference tiles on `device`. `instead`: why that is not the
/// GPU; none: it is what was asked for. It is read behind the tiles, since a GPU may fail at them. Errors: the
/// device's.
Result<wire::Hello> introduction(const NodeOptions& options, Device& device, const std::optional<Error>& instead = {});

/// States in `hello` which device renders. `instead`: as above.
void nameDevice(wire::Hello& hello, const DeviceInfo& device, const std::optional<Error>& instead);

}  // namespace pdr::node
