#pragma once
/// What a render node says of itself.

#include <optional>

#include "app/node/node_options.h"
#include "app/wire/messages.h"
#include "render/device/device.h"

namespace pdr::node {

/// Returns the first message to coordinators. Renders the reference tiles on `device`. Errors: the device's.
Result<wire::Hello> introduction(const NodeOptions& options, Device& device);

/// States in `hello` which device renders. `instead`: why it is not the GPU; none: it is what was asked for.
void nameDevice(wire::Hello& hello, const DeviceInfo& device, const std::optional<Error>& instead);

}  // namespace pdr::node
