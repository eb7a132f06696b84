// The bridges that can be a source, the simulated one first: each with what it is, what it says and whether
// it can be used.
#pragma once

#include "device/discovery/device_list.h"
#include "widgets/controls/text_label.h"

#include <QAbstractListModel>
#include <QListView>

#include <optional>

namespace driftbench {

// What the row of the source that runs says of it, as it streams.
struct StreamingText
{
    QString settings; // "L3GD20H, 245 dps, curved drift"
    double rateHz = 0.0;
    double temperatureC = 0.0;
    bool hasSamples = false;
};

struct BridgeState
{
    QString word;
    QString icon;
    Tone tone = Tone::Plain;
};

class BridgeModel : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role
    {
        AsideRole = Qt::UserRole,
        NoteRole,
        IconRole,
        StateWordRole,
        StateIconRole,
        StateToneRole,
        UsableRole
    };

    using QAbstractListModel::QAbstractListModel;

    void setDevices(const DeviceList &devices);
    const DeviceEntry &device(int row) const { return m_devices[static_cast<std::size_t>(row)]; }
    int rowOf(const std::string &source) const; // -1: it is not there
    // Which of them runs, by its source text; nothing: none.
    void setStreaming(const std::optional<std::string> &source, const StreamingText &text);
    int pluggedIn() const; // beside the simulated one
    int usable() const;    // of those

    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;

private:
    bool isStreaming(const DeviceEntry &entry) const;
    QString noteOf(const DeviceEntry &entry) const;
    BridgeState stateOf(const DeviceEntry &entry) const;

    DeviceList m_devices;
    std::optional<std::string> m_streaming;
    StreamingText m_text;
};

QString bridgeName(const DeviceEntry &entry);
// "1209:0001 · hidraw3", as far as it is known.
QString bridgePlace(const DeviceEntry &entry);
// The line of a udev rule that permits the device.
QString udevLine(const DeviceEntry &entry);

class BridgeList : public QListView
{
    Q_OBJECT

public:
    explicit BridgeList(QWidget *parent = nullptr);

    QSize sizeHint() const override; // as many rows as there are, at most four
    QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace driftbench
