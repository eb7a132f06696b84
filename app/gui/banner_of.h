// The content of a banner, for the usual case: what happened, what to do, and perhaps buttons. Words that are
// given as a function are said again when the language changes.
#pragma once

#include "widgets/controls/banner.h"

#include <concepts>
#include <functional>
#include <utility>

namespace driftbench {

class Words
{
public:
    Words() = default;
    Words(const QString &text) : m_say([text] { return text; }) {}
    template <std::invocable Say>
    Words(Say say) : m_say(std::move(say))
    {
    }

    QString text() const { return m_say ? m_say() : QString(); }

private:
    std::function<QString()> m_say;
};

inline std::function<BannerContent()> bannerOf(BannerKind kind, Words what, Words toDo,
                                               std::vector<QAction *> actions = {}, bool closable = true)
{
    return [kind, what = std::move(what), toDo = std::move(toDo), actions = std::move(actions), closable] {
        return BannerContent{kind, what.text(), toDo.text(), {}, {}, actions, closable};
    };
}

} // namespace driftbench
