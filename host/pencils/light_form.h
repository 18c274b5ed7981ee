// How an emitting shape's light enters: by light samples, or carried by the pencil maps.
#pragma once

namespace pencil {

enum class LightForm { samples, maps };

}  // namespace pencil
