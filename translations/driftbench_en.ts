<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>driftbench::ComparePage</name>
    <message numerus="yes">
        <source>%n held-out run(s)</source>
        <translation>
            <numerusform>%n held-out run</numerusform>
            <numerusform>%n held-out runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::DevicePanel</name>
    <message numerus="yes">
        <source>Verified at work: %n sample(s) compared with what the host computes, none differs.</source>
        <translation>
            <numerusform>Verified at work: %n sample compared with what the host computes, it does not differ.</numerusform>
            <numerusform>Verified at work: %n samples compared with what the host computes, none differs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::ExportPage</name>
    <message numerus="yes">
        <source>%n file(s) written to %1.</source>
        <translation>
            <numerusform>%n file written to %1.</numerusform>
            <numerusform>%n files written to %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written.</source>
        <translation>
            <numerusform>%n file written.</numerusform>
            <numerusform>%n files written.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written</source>
        <translation>
            <numerusform>%n file written</numerusform>
            <numerusform>%n files written</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::FileChoices</name>
    <message numerus="yes">
        <source>table, %n row(s)</source>
        <translation>
            <numerusform>table, %n row</numerusform>
            <numerusform>table, %n rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::InspectPage</name>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>exclude %1 s in %n stretches</source>
        <translation>
            <numerusform>exclude %1 s in %n stretch</numerusform>
            <numerusform>exclude %1 s in %n stretches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::LiveMarks</name>
    <message numerus="yes">
        <source>%1: %n samples dropped, %2</source>
        <translation>
            <numerusform>%1: %n sample dropped, %2</numerusform>
            <numerusform>%1: %n samples dropped, %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::ModelWords</name>
    <message numerus="yes">
        <source>%n centres</source>
        <translation>
            <numerusform>%n centre</numerusform>
            <numerusform>%n centres</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::PlanPage</name>
    <message numerus="yes">
        <source>%1 a run, %2 samples at %3 Hz · %4 for %n runs</source>
        <translation>
            <numerusform>%1 a run, %2 samples at %3 Hz · %4 for %n run</numerusform>
            <numerusform>%1 a run, %2 samples at %3 Hz · %4 for %n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::ProfileView</name>
    <message numerus="yes">
        <source>%n steps of %1 °C, %2 °C/min</source>
        <translation>
            <numerusform>%n step of %1 °C, %2 °C/min</numerusform>
            <numerusform>%n steps of %1 °C, %2 °C/min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RecentFilesModel</name>
    <message numerus="yes">
        <source>%1 of %n runs</source>
        <translation>
            <numerusform>%1 of %n run</numerusform>
            <numerusform>%1 of %n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n runs</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RecordPage</name>
    <message numerus="yes">
        <source>%n run(s) in the session</source>
        <translation>
            <numerusform>%n run in the session</numerusform>
            <numerusform>%n runs in the session</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::SourcePage</name>
    <message numerus="yes">
        <source>%n logs</source>
        <translation>
            <numerusform>%n log</numerusform>
            <numerusform>%n logs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bridges plugged in, %1 usable</source>
        <translation>
            <numerusform>%n bridge plugged in, %1 usable</numerusform>
            <numerusform>%n bridges plugged in, %1 usable</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Where the samples come from. %n runs so far.</source>
        <translation>
            <numerusform>Where the samples come from. %n run so far.</numerusform>
            <numerusform>Where the samples come from. %n runs so far.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::TrainOptions</name>
    <message numerus="yes">
        <source>%n, for every axis</source>
        <translation>
            <numerusform>%n, for every axis</numerusform>
            <numerusform>%n, for every axis</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::TrainPage</name>
    <message numerus="yes">
        <source>take %n centres</source>
        <translation>
            <numerusform>take %n centre</numerusform>
            <numerusform>take %n centres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n model(s)</source>
        <translation>
            <numerusform>%n model</numerusform>
            <numerusform>%n models</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s), %1 samples</source>
        <translation>
            <numerusform>%n run, %1 samples</numerusform>
            <numerusform>%n runs, %1 samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::VerdictCard</name>
    <message numerus="yes">
        <source>fails on %1 of %n runs</source>
        <translation>
            <numerusform>fails on %1 of %n run</numerusform>
            <numerusform>fails on %1 of %n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>passes on %1 of %n runs</source>
        <translation>
            <numerusform>passes on %1 of %n run</numerusform>
            <numerusform>passes on %1 of %n runs</numerusform>
        </translation>
    </message>
</context>
</TS>
