#include "app/gui/status_line.h"

#include "widgets/style/control_paint.h"
#include "widgets/style/theme.h"

#include <QHBoxLayout>
#include <QPainter>

#include <algorithm>

namespace driftbench {

static constexpr int kLeft = 12;
static constexpr int kRight = 10;
static constexpr int kBetween = 15;

namespace {

class UprightRule : public QWidget
{
public:
    explicit UprightRule(QWidget *parent) : QWidget(parent) { setFixedSize(1, 12); }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.fillRect(rect(), lookOf(palette()).border);
    }
};

} // namespace

StatusLine::StatusLine(QWidget *parent)
    : QStatusBar(parent), m_hints(new TextLabel(TextRole::Note, this)), m_layout(nullptr)
{
    setSizeGripEnabled(false);
    auto *content = new QWidget(this);
    m_layout = new QHBoxLayout(content);
    m_layout->setContentsMargins(kLeft, 0, kRight, 0);
    m_layout->setSpacing(kBetween);
    m_hints->setElided(true);
    m_layout->addWidget(m_hints, 1);
    addPermanentWidget(content, 1);
    layout()->setContentsMargins(0, 0, 0, 0);
    setContentsMargins(0, 0, 0, 0);
    setFixedHeight(std::max(kControlHeight, m_hints->fontMetrics().height() + 6));
}

void StatusLine::setHints(const QString &hints)
{
    m_hints->setText(hints);
    fit();
}

void StatusLine::setParts(const std::vector<StatusPart> &parts)
{
    m_wanted = parts;
    fit();
}

int StatusLine::widthOf(const std::vector<StatusPart> &parts) const
{
    int width = kLeft + kRight + m_hints->fontMetrics().horizontalAdvance(m_hints->text());
    for (const StatusPart &part : parts)
        width += 2 * kBetween + 1 + m_hints->fontMetrics().horizontalAdvance(part.text);
    return width;
}

void StatusLine::fit()
{
    std::vector<StatusPart> parts = m_wanted;
    while (widthOf(parts) > width()) {
        const auto first = std::max_element(parts.begin(), parts.end(),
                                            [](const auto &a, const auto &b) { return a.yields < b.yields; });
        if (first == parts.end() || first->yields == 0)
            break;
        parts.erase(first);
    }
    while (m_parts.size() < parts.size()) {
        auto *rule = new UprightRule(this);
        rule->setVisible(!m_parts.empty());
        m_layout->addWidget(rule);
        m_rules.push_back(rule);
        m_parts.push_back(new TextLabel(TextRole::Note, this));
        m_layout->addWidget(m_parts.back());
    }
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        const bool used = i < parts.size();
        m_parts[i]->setVisible(used);
        m_rules[i]->setVisible(used && i > 0);
        if (!used)
            continue;
        m_parts[i]->setTone(parts[i].tone);
        if (m_parts[i]->text() != parts[i].text)
            m_parts[i]->setText(parts[i].text);
    }
}

QStringList StatusLine::parts() const
{
    QStringList texts;
    for (const TextLabel *part : m_parts) {
        if (part->isVisibleTo(this))
            texts << part->text();
    }
    return texts;
}

void StatusLine::resizeEvent(QResizeEvent *event)
{
    QStatusBar::resizeEvent(event);
    fit();
}

void StatusLine::paintEvent(QPaintEvent *)
{
    const Palette &look = lookOf(palette());
    QPainter painter(this);
    painter.fillRect(rect(), look.window);
    painter.fillRect(0, 0, width(), 1, look.border);
}

} // namespace driftbench
