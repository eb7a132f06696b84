#include "app/gui/source/bridge_list.h"

#include "widgets/controls/icon.h"
#include "widgets/style/control_paint.h"
#include "widgets/style/fonts.h"
#include "widgets/style/number_text.h"
#include "widgets/style/theme.h"

#include <QPainter>
#include <QStyledItemDelegate>

namespace driftbench {

static constexpr int kRowHeight = 56;
static constexpr int kMostRows = 4;
static constexpr int kIconLeft = 17;
static constexpr int kTextLeft = 55;
static constexpr int kRight = 12;

QString bridgeName(const DeviceEntry &entry)
{
    switch (entry.kind) {
    case DeviceKind::SimulatedBridge:
        return BridgeModel::tr("Simulated bridge");
    case DeviceKind::NativeBridge:
        return BridgeModel::tr("Gyro bridge");
    case DeviceKind::I2cChip:
        return BridgeModel::tr("%1, USB to I2C").arg(QString::fromStdString(entry.name));
    }
    return {};
}

QString bridgePlace(const DeviceEntry &entry)
{
    QStringList parts;
    if (entry.identity.vendorId != 0)
        parts << QString::fromStdString(usbIdText({entry.identity.vendorId, entry.identity.productId}));
    if (!entry.identity.path.empty())
        parts << QString::fromStdString(entry.identity.path).section(QLatin1Char('/'), -1);
    return parts.join(QStringLiteral(" · "));
}

QString udevLine(const DeviceEntry &entry)
{
    return QStringLiteral(
               "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"%1\", ATTRS{idProduct}==\"%2\", TAG+=\"uaccess\"")
        .arg(entry.identity.vendorId, 4, 16, QLatin1Char('0'))
        .arg(entry.identity.productId, 4, 16, QLatin1Char('0'));
}

void BridgeModel::setDevices(const DeviceList &devices)
{
    if (devices.size() == m_devices.size()) {
        m_devices = devices;
        if (!devices.empty())
            emit dataChanged(index(0), index(rowCount() - 1));
        return;
    }
    beginResetModel();
    m_devices = devices;
    endResetModel();
}

int BridgeModel::rowOf(const std::string &source) const
{
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        if (m_devices[i].source == source)
            return static_cast<int>(i);
    }
    return -1;
}

void BridgeModel::setStreaming(const std::optional<std::string> &source, const StreamingText &text)
{
    m_streaming = source;
    m_text = text;
    if (!m_devices.empty())
        emit dataChanged(index(0), index(rowCount() - 1));
}

int BridgeModel::pluggedIn() const
{
    return std::max(0, rowCount() - 1);
}

int BridgeModel::usable() const
{
    return static_cast<int>(std::count_if(m_devices.begin(), m_devices.end(), [](const DeviceEntry &entry) {
        return entry.kind != DeviceKind::SimulatedBridge && (entry.usable() || entry.inUse);
    }));
}

int BridgeModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_devices.size());
}

bool BridgeModel::isStreaming(const DeviceEntry &entry) const
{
    return m_streaming && *m_streaming == entry.source;
}

QString BridgeModel::noteOf(const DeviceEntry &entry) const
{
    QStringList parts;
    const bool streaming = isStreaming(entry);
    if (entry.kind == DeviceKind::SimulatedBridge) {
        parts << (m_text.settings.isEmpty() ? tr("inside this program") : m_text.settings);
    } else {
        if (const std::string who = entry.identityText(); !who.empty() && entry.status.ok())
            parts << QString::fromStdString(who);
        parts << bridgePlace(entry);
        if (!entry.status.ok() && entry.status.error().code != Errc::DeviceNotPermitted)
            parts << QString::fromStdString(entry.sentence());
    }
    parts.removeAll(QString());
    if (streaming && m_text.hasSamples) {
        parts << tr("%1 Hz").arg(samplingRateText(m_text.rateHz));
        parts << tr("%1 °C").arg(numberText(m_text.temperatureC, 2));
    }
    return parts.join(QStringLiteral(" · "));
}

BridgeState BridgeModel::stateOf(const DeviceEntry &entry) const
{
    if (isStreaming(entry))
        return {m_text.hasSamples ? tr("Streaming") : tr("Opening"), QStringLiteral("check"), Tone::Good};
    if (entry.status.ok())
        return {entry.inUse ? tr("In use here") : tr("Ready"), QStringLiteral("ring"), Tone::Plain};
    switch (entry.status.error().code) {
    case Errc::DeviceNotPermitted:
        return {tr("Not permitted"), QStringLiteral("lock"), Tone::Caution};
    case Errc::DeviceHeldByKernel:
    case Errc::DeviceInUse:
        return {tr("In use"), QStringLiteral("warn"), Tone::Caution};
    case Errc::DeviceUnplugged:
        return {tr("Unplugged"), QStringLiteral("warn"), Tone::Caution};
    case Errc::BusNoAcknowledge:
        return {tr("No gyro answers"), QStringLiteral("warn"), Tone::Caution};
    case Errc::BusStuck:
        return {tr("Bus stuck"), QStringLiteral("cross"), Tone::Bad};
    case Errc::ProtocolVersion:
        return {tr("Other version"), QStringLiteral("cross"), Tone::Bad};
    case Errc::WrongSensor:
        return {tr("Unknown gyro"), QStringLiteral("cross"), Tone::Bad};
    default:
        return {tr("Not usable"), QStringLiteral("cross"), Tone::Bad};
    }
}

QVariant BridgeModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const DeviceEntry &entry = device(index.row());
    const BridgeState state = stateOf(entry);
    switch (role) {
    case Qt::DisplayRole:
        return bridgeName(entry);
    case AsideRole:
        return entry.kind == DeviceKind::SimulatedBridge ? tr("start here if you have no hardware")
                                                         : QString();
    case NoteRole:
        return noteOf(entry);
    case Qt::ToolTipRole:
        return entry.status.ok() ? noteOf(entry) : QString::fromStdString(entry.sentence());
    case Qt::AccessibleTextRole:
        return QStringList({bridgeName(entry), noteOf(entry), state.word}).join(QStringLiteral(", "));
    case IconRole:
        return entry.kind == DeviceKind::SimulatedBridge ? QStringLiteral("sim") : QStringLiteral("usb");
    case StateWordRole:
        return state.word;
    case StateIconRole:
        return state.icon;
    case StateToneRole:
        return static_cast<int>(state.tone);
    case UsableRole:
        return entry.usable() || isStreaming(entry);
    default:
        return {};
    }
}

namespace {

class BridgeDelegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override
    {
        return {200, kRowHeight};
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const Palette &look = lookOf(option.palette);
        const QRect row = option.rect;
        const bool last = index.row() == index.model()->rowCount() - 1;
        if (option.state & QStyle::State_Selected) {
            painter->fillRect(row, look.selection);
            painter->fillRect(QRect(row.left(), row.top(), 3, row.height()), look.accent);
        }
        if (!last)
            painter->fillRect(QRect(row.left(), row.bottom(), row.width(), 1), look.grid);
        paintIcon(*painter,
                  QRect(row.left() + kIconLeft, row.top() + (row.height() - kIcon) / 2, kIcon, kIcon),
                  index.data(BridgeModel::IconRole).toString(), look.text);
        const int stateLeft = paintState(*painter, row, index, look);
        paintTexts(*painter, row, stateLeft - 12, index, look);
    }

private:
    static int paintState(QPainter &painter, const QRect &row, const QModelIndex &index, const Palette &look)
    {
        const auto tone = static_cast<Tone>(index.data(BridgeModel::StateToneRole).toInt());
        const QString word = index.data(BridgeModel::StateWordRole).toString();
        const QColor color = tone == Tone::Plain ? look.mutedText : textColor(TextRole::NoteText, tone, look);
        const QFont font = tone == Tone::Plain ? noteFont() : strongNoteFont();
        const int left = row.right() - kRight - QFontMetrics(font).horizontalAdvance(word);
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRect(left, row.top(), row.right() - left + 1, row.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, word);
        const int iconLeft = left - kSmallIcon - 5;
        paintIcon(painter,
                  QRect(iconLeft, row.top() + (row.height() - kSmallIcon) / 2, kSmallIcon, kSmallIcon),
                  index.data(BridgeModel::StateIconRole).toString(), color);
        return iconLeft;
    }

    static void paintTexts(QPainter &painter, const QRect &row, int right, const QModelIndex &index,
                           const Palette &look)
    {
        const int left = row.left() + kTextLeft;
        const QFontMetrics nameMetrics(sectionFont());
        const QFontMetrics noteMetrics(noteFont());
        const int apart = noteMetrics.height() - 1;
        const int base =
            row.top() + (row.height() - nameMetrics.capHeight() - apart) / 2 + nameMetrics.capHeight();
        const QString name = index.data(Qt::DisplayRole).toString();
        painter.setFont(sectionFont());
        painter.setPen(look.text);
        painter.drawText(left, base, name);
        painter.setFont(noteFont());
        painter.setPen(look.mutedText);
        const int asideLeft = left + nameMetrics.horizontalAdvance(name) + 8;
        painter.drawText(asideLeft, base,
                         noteMetrics.elidedText(index.data(BridgeModel::AsideRole).toString(), Qt::ElideRight,
                                                std::max(0, right - asideLeft)));
        painter.drawText(left, base + apart,
                         noteMetrics.elidedText(index.data(BridgeModel::NoteRole).toString(), Qt::ElideRight,
                                                right - left));
    }
};

} // namespace

BridgeList::BridgeList(QWidget *parent) : QListView(parent)
{
    setItemDelegate(new BridgeDelegate(this));
    setFrameShape(QFrame::NoFrame);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setUniformItemSizes(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize BridgeList::sizeHint() const
{
    const int rows = model() ? std::clamp(model()->rowCount(), 1, kMostRows) : 1;
    return {300, rows * kRowHeight};
}

} // namespace driftbench
