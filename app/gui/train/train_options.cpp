#include "app/gui/train/train_options.h"

#include "app/gui/train/model_words.h"
#include "widgets/controls/form_rows.h"
#include "widgets/controls/number_field.h"
#include "widgets/controls/section_head.h"
#include "widgets/controls/segmented_buttons.h"
#include "widgets/controls/text_label.h"
#include "widgets/style/control_paint.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace driftbench {

static constexpr int kOptionsWidth = 232;
static constexpr int kLabelWidth = 80;
static constexpr std::array kLargestNumbers{12, 24, 48};
static constexpr int kFewestLevels = 3;
static constexpr int kMostLevels = 9;
static constexpr double kMostRidge = 1e6;
static constexpr double kMostSeed = 4294967295.0;

static bool has(const CalibrationPlan &plan, const std::string &model)
{
    return std::find(plan.models.begin(), plan.models.end(), model) != plan.models.end();
}

TrainOptions::TrainOptions(QWidget *parent)
    : QWidget(parent)
    , m_presetHead(new SectionHead)
    , m_modelsHead(new SectionHead)
    , m_inputsHead(new SectionHead)
    , m_optionsHead(new SectionHead)
    , m_preset(new SegmentedButtons({}, ButtonSize::Small))
    , m_form(new FormRows(kLabelWidth))
    , m_note(new TextLabel(TextRole::Note))
{
    setFixedWidth(kOptionsWidth);
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    m_preset->setStretched(true);
    m_note->setWordWrap(true);
    buildModels();
    buildForm();
    rows->addWidget(m_presetHead);
    rows->addWidget(m_preset);
    rows->addWidget(m_modelsHead);
    rows->addWidget(m_rbf);
    for (const char *name : {"bpnn", "cubic", "cubic-ardupilot", "linear"})
        rows->addWidget(m_models.at(name));
    rows->addWidget(m_inputsHead);
    auto *inputs = new QHBoxLayout;
    inputs->setSpacing(6);
    for (QCheckBox *input : m_inputs)
        inputs->addWidget(input);
    inputs->addWidget(m_dynamic);
    inputs->addStretch(1);
    rows->addLayout(inputs);
    rows->addWidget(m_optionsHead);
    rows->addWidget(m_form);
    rows->addStretch(1);
    rows->addWidget(m_note);
    connect(m_preset, &SegmentedButtons::currentChanged, this, &TrainOptions::takeModels);
}

void TrainOptions::buildModels()
{
    m_rbf = new QCheckBox(this);
    connect(m_rbf, &QCheckBox::toggled, this, &TrainOptions::takeModels);
    for (const char *name : {"bpnn", "cubic", "cubic-ardupilot", "linear"}) {
        auto *box = new QCheckBox(this);
        connect(box, &QCheckBox::toggled, this, &TrainOptions::takeModels);
        m_models.emplace(name, box);
    }
    for (std::size_t i = 0; i < m_inputs.size(); ++i) {
        m_inputs[i] = new QCheckBox(this);
        connect(m_inputs[i], &QCheckBox::toggled, this, [this, i](bool on) {
            edit(tr("inputs of the RBF network"),
                 [i, on](CalibrationPlan &plan) { plan.rbf.inputs[i] = on; });
        });
    }
    m_inputs[0]->setEnabled(false); // without it temperatures can't be told apart
    m_dynamic = new QCheckBox(this);
    m_dynamic->setEnabled(false);
}

void TrainOptions::buildForm()
{
    m_centres = new QComboBox;
    m_widths = new QComboBox;
    m_holdOut = new QComboBox;
    m_judged = new QComboBox;
    m_ridge = new NumberField({}, {}, 2, 0.0, kMostRidge, 0.5);
    m_hidden = new NumberField({}, {}, 0, 1, 100, 1);
    m_starts = new NumberField({}, {}, 0, 1, 100, 1);
    m_seed = new NumberField({}, {}, 0, 0, kMostSeed, 1);
    for (QWidget *field : std::initializer_list<QWidget *>{m_centres, m_widths, m_ridge, m_hidden, m_starts,
                                                           m_seed, m_holdOut, m_judged})
        m_form->addRow({}, field);
    connect(m_centres, &QComboBox::activated, this, [this](int index) {
        const int value = m_centres->itemData(index).toInt();
        edit(tr("number of centres"), [value](CalibrationPlan &plan) {
            plan.rbf.centres = value > 0 ? -1 : -value - 1;
            if (value > 0)
                plan.rbf.largestNumberOfCentres = value;
        });
    });
    connect(m_widths, &QComboBox::activated, this, [this](int index) {
        const int levels = m_widths->itemData(index).toInt();
        edit(tr("widths"), [levels](CalibrationPlan &plan) { plan.rbf.levels = levels; });
    });
    connect(m_ridge, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("ridge"), [value](CalibrationPlan &plan) { plan.rbf.ridge = value; });
    });
    connect(m_hidden, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("hidden units"), [value](CalibrationPlan &plan) { plan.bp.hiddenUnits = int(value); });
    });
    connect(m_starts, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("starts"), [value](CalibrationPlan &plan) { plan.bp.starts = int(value); });
    });
    connect(m_seed, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(tr("seed"), [value](CalibrationPlan &plan) { plan.seed = static_cast<std::uint64_t>(value); });
    });
    connect(m_holdOut, &QComboBox::activated, this, [this](int index) {
        const auto run = static_cast<RunId>(m_holdOut->itemData(index).toLongLong());
        edit(tr("hold-out"), [run](CalibrationPlan &plan) {
            plan.holdOut.clear();
            if (run != 0)
                plan.holdOut.push_back(run);
        });
    });
    connect(m_judged, &QComboBox::activated, this, [this](int index) {
        const Judging judging = index == 0 ? Judging::Absolute : Judging::Anchored;
        edit(tr("judging"), [judging](CalibrationPlan &plan) { plan.judging = judging; });
    });
    for (NumberField *field : {m_ridge, m_hidden, m_starts, m_seed})
        field->setKeyboardTracking(false);
}

void TrainOptions::edit(const QString &step, const std::function<void(CalibrationPlan &)> &change)
{
    if (m_showing)
        return;
    CalibrationPlan plan = m_plan;
    change(plan);
    if (!(plan == m_plan))
        emit edited(plan, step);
}

// In the order of defaultModelNames; the constant is the yardstick and always there.
void TrainOptions::takeModels()
{
    edit(tr("models"), [this](CalibrationPlan &plan) {
        std::vector<std::string> models{"constant"};
        for (const char *name : {"linear", "cubic", "cubic-ardupilot", "bpnn"}) {
            if (m_models.at(name)->isChecked())
                models.emplace_back(name);
        }
        const int preset = m_preset->current();
        if (m_rbf->isChecked() && preset != Best)
            models.emplace_back("rbf-paper");
        if (m_rbf->isChecked() && preset != Paper)
            models.emplace_back("rbf");
        plan.models = std::move(models);
    });
}

void TrainOptions::showModels()
{
    const bool best = has(m_plan, "rbf");
    const bool paper = has(m_plan, "rbf-paper");
    m_rbf->setChecked(best || paper);
    if (best || paper)
        m_preset->setCurrent(best && paper ? Both : best ? Best : Paper);
    for (const auto &[name, box] : m_models)
        box->setChecked(has(m_plan, name));
    for (std::size_t i = 0; i < m_inputs.size(); ++i)
        m_inputs[i]->setChecked(m_plan.rbf.inputs[i]);
    m_preset->setEnabled(m_rbf->isChecked());
}

void TrainOptions::showHoldOut()
{
    m_holdOut->clear();
    m_holdOut->addItem(tr("One run in turn"), QVariant::fromValue<qlonglong>(0));
    for (const RunRecord &run : m_runs) {
        const RunInPlan *planned = m_plan.find(run.id);
        if (planned != nullptr && planned->takesPart)
            m_holdOut->addItem(tr("Only %1").arg(QString::fromStdString(run.description.name)),
                               QVariant::fromValue<qlonglong>(run.id));
    }
    if (m_runs.size() == 1)
        m_holdOut->setItemText(0, tr("Blocks of temperature"));
    if (!m_plan.holdOut.empty())
        m_holdOut->setCurrentIndex(
            std::max(0, m_holdOut->findData(QVariant::fromValue<qlonglong>(m_plan.holdOut.front()))));
}

void TrainOptions::fillChoices()
{
    m_centres->clear();
    for (const int most : kLargestNumbers)
        m_centres->addItem(tr("Auto, up to %1").arg(most), most);
    const bool given = m_plan.rbf.centres >= 0;
    const int largest = m_plan.rbf.largestNumberOfCentres;
    if (given)
        m_centres->addItem(tr("%n, for every axis", nullptr, m_plan.rbf.centres), -m_plan.rbf.centres - 1);
    else if (m_centres->findData(largest) < 0)
        m_centres->addItem(tr("Auto, up to %1").arg(largest), largest);
    m_centres->setCurrentIndex(m_centres->findData(given ? -m_plan.rbf.centres - 1 : largest));
    m_widths->clear();
    for (int levels = kFewestLevels; levels <= kMostLevels; ++levels)
        m_widths->addItem(tr("Auto, %1 tried").arg(levels), levels);
    m_widths->setCurrentIndex(std::clamp(m_plan.rbf.levels, kFewestLevels, kMostLevels) - kFewestLevels);
    m_judged->clear();
    m_judged->addItems({tr("Absolute"), tr("Anchored")});
    m_judged->setCurrentIndex(m_plan.judging == Judging::Absolute ? 0 : 1);
}

void TrainOptions::show(const CalibrationPlan &plan, const std::vector<RunRecord> &runs)
{
    m_showing = true;
    m_plan = plan;
    m_runs = runs;
    fillChoices();
    showModels();
    showHoldOut();
    m_ridge->setValue(plan.rbf.ridge);
    m_hidden->setValue(plan.bp.hiddenUnits);
    m_starts->setValue(plan.bp.starts);
    m_seed->setValue(static_cast<double>(plan.seed));
    const bool rbf = has(plan, "rbf") || has(plan, "rbf-paper");
    for (QWidget *field : std::initializer_list<QWidget *>{m_centres, m_ridge, m_inputs[1], m_inputs[2]})
        field->setEnabled(rbf);
    m_widths->setEnabled(has(plan, "rbf"));
    m_hidden->setEnabled(has(plan, "bpnn"));
    m_starts->setEnabled(has(plan, "bpnn"));
    m_showing = false;
}

void TrainOptions::setNote(const QString &note)
{
    m_note->setText(note);
}

void TrainOptions::explain()
{
    m_rbf->setToolTip(tr("Gaussians on the temperature quantities, placed by orthogonal least squares."));
    m_models.at("bpnn")->setToolTip(tr("A network with tanh units, trained from several seeded starts."));
    m_models.at("cubic")->setToolTip(tr("As PX4 fits it: medians, 2 000 bins of temperature, a cubic."));
    m_models.at("cubic-ardupilot")
        ->setToolTip(tr("As ArduPilot fits it: means of 2 s, a cubic about 35 °C."));
    m_models.at("linear")->setToolTip(tr("Least squares on ΔT."));
    m_inputs[0]->setToolTip(tr("Always in: the others can't tell every temperature from every other."));
    m_dynamic->setToolTip(
        tr("The rate of the temperature is an experiment: it did not survive on recorded runs "
           "held out, and no table could hold it. driftbench-cli fit --dynamic measures it."));
    m_centres->setToolTip(tr("Auto: the smallest number that does as well as the best on runs left out."));
    m_widths->setToolTip(tr("Widths of the Gaussians, each half the one before, from the whole span down."));
    m_ridge->setToolTip(tr("How many samples' worth of doubt shrinks each Gaussian. More is smoother."));
    m_hidden->setToolTip(tr("Tanh units in the hidden layer of the BP network."));
    m_starts->setToolTip(tr("Seeded starts of the BP network; the best one counts."));
    m_seed->setToolTip(tr("Same runs, options and seed: the same models, bit for bit."));
    m_holdOut->setToolTip(tr("Which runs are judged by models that have not seen them."));
    m_judged->setToolTip(
        tr("Absolute: the turn-on bias counts, as in PX4. Anchored: the bias at the start of each "
           "run is removed, as ArduPilot does."));
}

void TrainOptions::retranslate()
{
    m_showing = true;
    m_presetHead->setTitle(tr("Preset"));
    m_modelsHead->setTitle(tr("Models"));
    m_inputsHead->setTitle(tr("RBF inputs"));
    m_optionsHead->setTitle(tr("Options"));
    m_preset->setTexts({tr("Best"), tr("Paper"), tr("Both")});
    m_rbf->setText(tr("RBF network"));
    m_models.at("bpnn")->setText(tr("BP network"));
    m_models.at("cubic")->setText(tr("Cubic in ΔT, as PX4"));
    m_models.at("cubic-ardupilot")->setText(tr("Cubic in ΔT, as ArduPilot"));
    m_models.at("linear")->setText(tr("Line in ΔT"));
    m_inputs[0]->setText(QStringLiteral("ΔT"));
    m_inputs[1]->setText(QStringLiteral("ΔT²"));
    m_inputs[2]->setText(QStringLiteral("√ΔT"));
    m_dynamic->setText(QStringLiteral("dT/dt"));
    m_form->setLabel(Centres, tr("Centres"));
    m_form->setLabel(Widths, tr("Widths"));
    m_form->setLabel(Ridge, tr("Ridge"));
    m_form->setLabel(Hidden, tr("BP units"));
    m_form->setLabel(Starts, tr("BP starts"));
    m_form->setLabel(Seed, tr("Seed"));
    m_form->setLabel(HoldOut, tr("Hold out"));
    m_form->setLabel(Judged, tr("Judged"));
    m_preset->setAccessibleName(tr("Preset of the RBF network"));
    m_ridge->setAccessibleName(tr("Ridge"));
    m_hidden->setAccessibleName(tr("Hidden units of the BP network"));
    m_starts->setAccessibleName(tr("Starts of the BP network"));
    m_seed->setAccessibleName(tr("Seed"));
    m_centres->setAccessibleName(tr("Number of centres"));
    m_widths->setAccessibleName(tr("Widths"));
    m_holdOut->setAccessibleName(tr("Hold out"));
    m_judged->setAccessibleName(tr("Judged"));
    explain();
    show(m_plan, m_runs);
}

} // namespace driftbench
