#include "app/gui/export/device_panel.h"

#include "app/gui/export/device_words.h"
#include "app/gui/export/upload_steps.h"
#include "app/gui/workbench.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/section_head.h"
#include "widgets/style/role_pens.h"
#include "widgets/tables/pairs_table_model.h"
#include "widgets/views/table_error_view.h"

#include <QStackedWidget>

#include <algorithm>

namespace driftbench {

// By this session's uploads; an image itself does not say.
QString DevicePanel::modelOf(std::uint32_t crc) const
{
    for (const UploadRecord &upload : m_bench.session().uploads()) {
        if (upload.crc32 != crc)
            continue;
        const auto models = m_bench.session().file().models();
        if (!models || !upload.model)
            break;
        for (const ModelRecord &model : *models) {
            if (model.id == *upload.model)
                return deviceModelName(model.name);
        }
    }
    return tr("not known here");
}

static std::optional<DeviceImage> decoded(const std::vector<std::uint8_t> &bytes)
{
    auto image = decodeDeviceImage(bytes, "the table");
    return image ? std::optional(*std::move(image)) : std::nullopt;
}

void DevicePanel::showFacts()
{
    const QString none = QStringLiteral("–");
    std::vector<FactPair> pairs{{tr("Bank, generation"), m_tables ? tr("none") : tr("not known"), none},
                                {tr("Model"), none, none},
                                {tr("Range, rows"), none, none},
                                {tr("Kind"), none, none},
                                {tr("Sensor"), none, none},
                                {tr("CRC-32"), none, none}};
    std::shared_ptr<const CompensationTable> current, fresh;
    const auto fill = [&pairs](const DeviceImage &image, std::uint32_t crc, QString FactPair::*side) {
        pairs[2].*side = rangeText(image.table);
        pairs[3].*side = tr("%1, %2").arg(kindText(image.kind()), thermometerText(image.thermometer));
        pairs[4].*side = sensorText(image.table.provenance.sensor);
        pairs[5].*side = crcText(crc);
    };
    if (m_tables && m_tables->image) {
        if (const auto image = decoded(*m_tables->image)) {
            const std::uint32_t crc = deviceImageCrc(*m_tables->image);
            fill(*image, crc, &FactPair::here);
            pairs[1].here = modelOf(crc);
            current = std::make_shared<const CompensationTable>(image->table);
        }
    }
    if (m_tables && m_tables->status.activeBank) {
        const std::uint8_t bank = *m_tables->status.activeBank;
        pairs[0].here = tr("%1, %2, active").arg(bankName(bank)).arg(m_tables->status.banks[bank].generation);
    }
    if (m_preview && !m_preview->image.empty()) {
        if (const auto image = decoded(m_preview->image)) {
            fill(*image, deviceImageCrc(m_preview->image), &FactPair::there);
            pairs[1].there = QString::fromStdString(m_modelName);
            fresh = std::make_shared<const CompensationTable>(image->table);
        }
        if (m_tables) {
            std::uint32_t latest = 0;
            for (const BridgeBank &bank : m_tables->status.banks)
                latest = std::max(latest, bank.generation);
            const std::uint8_t spare = m_tables->status.activeBank == std::uint8_t{0} ? 1 : 0;
            pairs[0].there = tr("%1, %2").arg(bankName(spare)).arg(latest + 1);
        }
    } else if (m_preview && m_preview->imageRefusal) {
        pairs[1].there = tr("no image: see Files");
    }
    m_pairsModel->setHeads(tr("On the device now"), tr("Would be written"));
    m_pairsModel->setPairs(std::move(pairs));
    m_difference->setData(current, fresh);
    const bool simulated = m_bench.sourceChoice() && m_bench.isSourceSimulated();
    if (m_tables) {
        m_head->setTitle(tr("Device %1").arg(QString::fromStdString(m_tables->device.sensor.serial)));
        const QString firmware = QString::fromStdString(m_tables->device.firmwareText());
        const QString model = QString::fromStdString(m_tables->device.sensor.model);
        m_head->setNote(simulated ? tr("%1, firmware %2, simulated").arg(model, firmware)
                                  : tr("%1, firmware %2").arg(model, firmware));
    } else {
        m_head->setTitle(tr("Device"));
        m_head->setNote(problem());
    }
    // Where an upload was cut off stays in sight, though the device is gone.
    const bool cutOff = m_problem && m_steps->state() == UploadSteps::State::Failed;
    m_stack->setCurrentIndex(m_tables || m_writing || cutOff ? 1 : 0);
    if (!m_bench.sourceChoice())
        m_empty->setTexts(tr("No device chosen"),
                          tr("Choose the simulated bridge or a plugged-in one as source."));
    else if (m_problem)
        m_empty->setTexts(tr("No tables there"), QString::fromStdString(m_problem->message));
    else
        m_empty->setTexts(tr("Looking at the device"), m_bench.sourceName());
    m_empty->setActions(!m_bench.sourceChoice() ? std::vector<QAction *>{m_toSource}
                        : m_problem             ? std::vector<QAction *>{m_look, m_toSource}
                                                : std::vector<QAction *>{});
    emit stateChanged();
}

} // namespace driftbench
