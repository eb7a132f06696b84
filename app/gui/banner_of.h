// The content of a banner, for the usual case: what happened, what to do, and perhaps buttons.
#pragma once

#include "widgets/controls/banner.h"

#include <utility>

namespace driftbench {

inline BannerContent bannerOf(BannerKind kind, const QString &what, const QString &toDo,
                              std::vector<QAction *> actions = {})
{
    return {kind, what, toDo, {}, {}, std::move(actions), true};
}

} // namespace driftbench
