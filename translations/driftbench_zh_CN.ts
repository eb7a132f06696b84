<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>SimulatedTour</name>
    <message>
        <source>Choose where the samples come from.</source>
        <translation>选择样本的来源。</translation>
    </message>
    <message>
        <source>The simulated bridge runs the firmware of a real one over a simulated gyro in a chamber. Next uses it.</source>
        <translation>仿真桥接器以真实桥接器的固件驱动温箱中的仿真陀螺。“下一步”即采用它。</translation>
    </message>
    <message>
        <source>Plan how the temperature moves.</source>
        <translation>计划温度的变化。</translation>
    </message>
    <message>
        <source>From −40 to 85 °C in steps that the datasheets allow. The tour takes three runs instead of five; each is judged by a model of the others.</source>
        <translation>从 −40 至 85 °C，步长为数据手册所允许。导览取三个测次而非五个；每个测次由其余测次的模型评判。</translation>
    </message>
    <message>
        <source>Record the runs.</source>
        <translation>采集测次。</translation>
    </message>
    <message>
        <source>Three hours pass in about twelve seconds. Everything is in the session&apos;s file as it comes.</source>
        <translation>三小时在约十二秒内过去。所有数据随到随存入会话文件。</translation>
    </message>
    <message>
        <source>Recording run %1 of %2.</source>
        <translation>正在采集测次 %1/%2。</translation>
    </message>
    <message>
        <source>Look at the drift.</source>
        <translation>查看漂移。</translation>
    </message>
    <message>
        <source>Train the models.</source>
        <translation>训练模型。</translation>
    </message>
    <message>
        <source>An RBF network and its rivals. Each run is held out once, so that no model is judged on what it has seen.</source>
        <translation>RBF 网络与其对手。各测次逐次留出，使模型不在其见过的数据上评判。</translation>
    </message>
    <message>
        <source>Read the verdict.</source>
        <translation>查看判定。</translation>
    </message>
    <message>
        <source>For each axis: write the table, only a constant, or nothing, with the reason.</source>
        <translation>各轴：写补偿表、仅写常数或不写，并附原因。</translation>
    </message>
    <message>
        <source>Write the table into the device.</source>
        <translation>将补偿表写入设备。</translation>
    </message>
    <message>
        <source>Written to the spare bank, read back, verified, and only then made active. Cut off anywhere, the old table stays.</source>
        <translation>写入备用区，回读，校验，之后才激活。任何时刻中断，旧补偿表均保留。</translation>
    </message>
    <message>
        <source>That did not work; the page says why. Try again, or skip it.</source>
        <translation>未成功，原因见该页。请重试或跳过。</translation>
    </message>
    <message>
        <source>No bridge is chosen; choose the simulated one on the Source page.</source>
        <translation>未选择桥接器；请在数据源页选择仿真桥接器。</translation>
    </message>
    <message>
        <source>The training ended without a model. Try again, or skip it.</source>
        <translation>训练结束但没有模型。请重试或跳过。</translation>
    </message>
    <message>
        <source>There is no model to write; go back to Train, or end the tour.</source>
        <translation>没有可写入的模型；请返回训练或结束导览。</translation>
    </message>
    <message>
        <source>The device computed something else with the new table and has its old one again. Try again, or skip it.</source>
        <translation>设备用新表的计算结果不符，已恢复旧表。请重试或跳过。</translation>
    </message>
    <message>
        <source>The bridge was unplugged. Plug it in and try again, or stop the run and end the tour.</source>
        <translation>桥接器被拔出。请插回后重试，或停止采集并结束导览。</translation>
    </message>
    <message>
        <source>Each sample&apos;s error against temperature. Where they lie on one curve, a table can remove it.</source>
        <translation>每个样本的误差随温度的变化。落在同一条曲线上，补偿表就能消除它。</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Source</source>
        <translation>数据源</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>训练</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Choose one</source>
        <translation>请选择</translation>
    </message>
    <message>
        <source>Temperature steps</source>
        <translation>温度步进</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>实时曲线</translation>
    </message>
    <message>
        <source>Look at the drift</source>
        <translation>查看漂移</translation>
    </message>
    <message>
        <source>Fit models</source>
        <translation>拟合模型</translation>
    </message>
    <message>
        <source>Judge the fit</source>
        <translation>评判拟合</translation>
    </message>
    <message>
        <source>Write the table</source>
        <translation>写入补偿表</translation>
    </message>
</context>
<context>
    <name>driftbench::AllanView</name>
    <message>
        <source>Allan deviation before and after compensation</source>
        <translation>补偿前后的 Allan 偏差</translation>
    </message>
    <message>
        <source>No Allan deviation</source>
        <translation>无 Allan 偏差</translation>
    </message>
    <message>
        <source>It needs a stretch of nine samples or more without a gap.</source>
        <translation>需要一段无间断且不少于九个样本的区段。</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>补偿前</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>补偿后，%1</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>平均时间 τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>最低：补偿前 %1，补偿后 %2 dps</translation>
    </message>
</context>
<context>
    <name>driftbench::Banner</name>
    <message>
        <source>Line to copy</source>
        <translation>待复制的行</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>driftbench::BeforeAfterView</name>
    <message>
        <source>Rates before and after compensation</source>
        <translation>补偿前后的角速率</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>%1 角速率 (dps)</translation>
    </message>
    <message>
        <source>%1 dps rms raw</source>
        <translation>原始 %1 dps rms</translation>
    </message>
    <message>
        <source>%1 dps rms comp.</source>
        <translation>补偿后 %1 dps rms</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Nothing to compare yet</source>
        <translation>尚无可比较内容</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>请训练模型，并选择其未见过的测次。</translation>
    </message>
    <message>
        <source>Raw, mean and range</source>
        <translation>原始，均值与范围</translation>
    </message>
    <message>
        <source>Compensated, %1</source>
        <translation>补偿后，%1</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>起始后时间</translation>
    </message>
</context>
<context>
    <name>driftbench::BridgeModel</name>
    <message>
        <source>Simulated bridge</source>
        <translation>仿真桥接器</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>陀螺桥接器</translation>
    </message>
    <message>
        <source>%1, USB to I2C</source>
        <translation>%1，USB 转 I2C</translation>
    </message>
    <message>
        <source>inside this program</source>
        <translation>程序内置</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Streaming</source>
        <translation>传输中</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>打开中</translation>
    </message>
    <message>
        <source>In use here</source>
        <translation>本程序占用</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Not permitted</source>
        <translation>无权限</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>被占用</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>已拔出</translation>
    </message>
    <message>
        <source>No gyro answers</source>
        <translation>陀螺无应答</translation>
    </message>
    <message>
        <source>Bus stuck</source>
        <translation>总线卡死</translation>
    </message>
    <message>
        <source>Other version</source>
        <translation>版本不符</translation>
    </message>
    <message>
        <source>Unknown gyro</source>
        <translation>未知陀螺</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source>start here if you have no hardware</source>
        <translation>没有硬件可由此开始</translation>
    </message>
</context>
<context>
    <name>driftbench::CentresView</name>
    <message>
        <source>Number of centres</source>
        <translation>中心数</translation>
    </message>
    <message>
        <source>RBF training</source>
        <translation>RBF 训练</translation>
    </message>
    <message>
        <source>RBF held out</source>
        <translation>RBF 留出</translation>
    </message>
    <message>
        <source>%1 chosen</source>
        <translation>选取 %1</translation>
    </message>
    <message>
        <source>RBF, temperature blocks left out</source>
        <translation>RBF，温度块留出</translation>
    </message>
    <message>
        <source>RBF held out, mean of %1</source>
        <translation>RBF 留出，%1 次均值</translation>
    </message>
    <message>
        <source>RBF held out, mean</source>
        <translation>RBF 留出，均值</translation>
    </message>
    <message>
        <source>Excess over the noise floor</source>
        <translation>超出本底噪声的量</translation>
    </message>
    <message>
        <source>lowest to highest run</source>
        <translation>最低至最高测次</translation>
    </message>
    <message>
        <source>lowest to highest block</source>
        <translation>最低至最高温度块</translation>
    </message>
    <message>
        <source>Chosen number</source>
        <translation>选取的中心数</translation>
    </message>
    <message>
        <source>Excess MSD (%)</source>
        <translation>MSD 超出量 (%)</translation>
    </message>
    <message>
        <source>Excess over the noise floor against the number of centres</source>
        <translation>超出本底噪声的量与中心数的关系</translation>
    </message>
    <message>
        <source>The curve, its centres and their widths</source>
        <translation>曲线及其中心与宽度</translation>
    </message>
    <message>
        <source>Centres of the RBF network</source>
        <translation>RBF 网络的中心</translation>
    </message>
    <message>
        <source>The curve, less its straight line</source>
        <translation>减去直线后的曲线</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>RBF 网络</translation>
    </message>
    <message>
        <source>Means of 1 °C</source>
        <translation>每 1 °C 均值</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Width, ±1 σ</source>
        <translation>宽度，±1 σ</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>TDE less line (dps)</source>
        <translation>TDE 减直线 (dps)</translation>
    </message>
    <message>
        <source>No RBF network yet</source>
        <translation>尚无 RBF 网络</translation>
    </message>
    <message>
        <source>Train one to see how many centres it needs.</source>
        <translation>训练后可知所需的中心数。</translation>
    </message>
    <message>
        <source>No choice was made</source>
        <translation>未做选择</translation>
    </message>
    <message>
        <source>The number of centres was given, so none was tried.</source>
        <translation>中心数已指定，未做试选。</translation>
    </message>
</context>
<context>
    <name>driftbench::CoachStrip</name>
    <message>
        <source>Guided tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>Guided tour, %1 of %2</source>
        <translation>导览，%1/%2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>结束导览</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
</context>
<context>
    <name>driftbench::ComparePage</name>
    <message>
        <source>Held-out run</source>
        <translation>留出测次</translation>
    </message>
    <message>
        <source>Comparison of the models on the held-out run</source>
        <translation>各模型在留出测次上的比较</translation>
    </message>
    <message>
        <source>Limit of what may be left, rms</source>
        <translation>允许残余的限值，rms</translation>
    </message>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>评判方式</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>报告进度</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>评判方式</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>写报告</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML, one file (*.html)</source>
        <translation>HTML，单文件 (*.html)</translation>
    </message>
    <message>
        <source>There is nothing to report yet.</source>
        <translation>尚无可写入报告的内容。</translation>
    </message>
    <message>
        <source>Train a model first; its runs must be readable.</source>
        <translation>请先训练模型；其测次必须可读。</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>报告已写入 %1。</translation>
    </message>
    <message>
        <source>The report is written.</source>
        <translation>报告已写入。</translation>
    </message>
    <message>
        <source>The report was not written.</source>
        <translation>报告未写入。</translation>
    </message>
    <message>
        <source>Models against a constant, on runs they have not seen</source>
        <translation>各模型与常数之比较，用其未见过的测次</translation>
    </message>
    <message>
        <source>%1 against a constant, on runs it has not seen</source>
        <translation>%1 与常数之比较，用其未见过的测次</translation>
    </message>
    <message>
        <source>The models are trained and judged on runs held out.</source>
        <translation>模型正在训练，并用留出测次评判。</translation>
    </message>
    <message>
        <source>Nothing to judge</source>
        <translation>无可评判内容</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>请先训练模型。</translation>
    </message>
    <message>
        <source>%1 of 3 axes: yes</source>
        <translation>3 轴中 %1 轴：是</translation>
    </message>
    <message>
        <source>1, 2, 3 choose the held-out run · Wheel zoom · Drag pan · Double-click fit · Ctrl+E export what is visible</source>
        <translation>1、2、3 选择留出测次 · 滚轮 缩放 · 拖动 平移 · 双击 适应窗口 · Ctrl+E 导出可见部分</translation>
    </message>
    <message numerus="yes">
        <source>%n held-out run(s)</source>
        <translation>
            <numerusform>%n 个留出测次</numerusform>
        </translation>
    </message>
    <message>
        <source>Judged: anchored</source>
        <translation>评判：锚定</translation>
    </message>
    <message>
        <source>Judged: absolute</source>
        <translation>评判：绝对</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>What may be left on a held-out run, rms. Zero: no limit.</source>
        <translation>留出测次上允许的残余，rms。零：无限值。</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>绝对</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>锚定</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>Everything found as PDF or as one HTML file</source>
        <translation>将全部结果写成 PDF 或单个 HTML 文件</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>训练</translation>
    </message>
    <message>
        <source>Held-out run %1</source>
        <translation>留出测次 %1</translation>
    </message>
    <message>
        <source>The report was cancelled.</source>
        <translation>报告已取消。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>driftbench::ComparisonTableModel</name>
    <message>
        <source>Pass</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Fail</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>MSD1
before</source>
        <translation>MSD1
补偿前</translation>
    </message>
    <message>
        <source>MSD4
Conv. 1</source>
        <translation>MSD4
常规 1</translation>
    </message>
    <message>
        <source>MSD5
Conv. 2</source>
        <translation>MSD5
常规 2</translation>
    </message>
    <message>
        <source>MSD6
Novel</source>
        <translation>MSD6
新型</translation>
    </message>
    <message>
        <source>Q3
Conv. 1</source>
        <translation>Q3
常规 1</translation>
    </message>
    <message>
        <source>Q4
Conv. 2</source>
        <translation>Q4
常规 2</translation>
    </message>
    <message>
        <source>Q5
Novel</source>
        <translation>Q5
新型</translation>
    </message>
    <message>
        <source>Q4 − Q3
% of Q3</source>
        <translation>Q4 − Q3
Q3 的 %</translation>
    </message>
    <message>
        <source>Q5 − Q3
% of Q3</source>
        <translation>Q5 − Q3
Q3 的 %</translation>
    </message>
    <message>
        <source>Q5 − Q4
% of Q4</source>
        <translation>Q5 − Q4
Q4 的 %</translation>
    </message>
    <message>
        <source>MSD
cubic</source>
        <translation>MSD
三次</translation>
    </message>
    <message>
        <source>MSD
constant</source>
        <translation>MSD
常数</translation>
    </message>
    <message>
        <source>MSD
floor</source>
        <translation>MSD
本底</translation>
    </message>
    <message>
        <source>Left
dps rms</source>
        <translation>残余
dps rms</translation>
    </message>
    <message>
        <source>Limit
%1</source>
        <translation>限值
%1</translation>
    </message>
    <message>
        <source>Limit
none</source>
        <translation>限值
无</translation>
    </message>
</context>
<context>
    <name>driftbench::CoverageView</name>
    <message>
        <source>Coverage of the temperature range</source>
        <translation>温度范围的覆盖</translation>
    </message>
    <message>
        <source>No coverage yet</source>
        <translation>尚无覆盖数据</translation>
    </message>
    <message>
        <source>It shows where the temperature has been.</source>
        <translation>显示温度经过的范围。</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>s per °C</source>
        <translation>s/°C</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>升温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
</context>
<context>
    <name>driftbench::CurvePanelsView</name>
    <message>
        <source>No curves</source>
        <translation>无曲线</translation>
    </message>
    <message>
        <source>There is nothing to draw over this range.</source>
        <translation>此范围内无可绘制内容。</translation>
    </message>
</context>
<context>
    <name>driftbench::DataTable</name>
    <message>
        <source>Copy selected cells</source>
        <translation>复制所选单元格</translation>
    </message>
    <message>
        <source>Copy table as text</source>
        <translation>复制表格为文本</translation>
    </message>
    <message>
        <source>Copy table as CSV</source>
        <translation>复制表格为 CSV</translation>
    </message>
    <message>
        <source>Copy table as Markdown</source>
        <translation>复制表格为 Markdown</translation>
    </message>
    <message>
        <source>Copy table as LaTeX</source>
        <translation>复制表格为 LaTeX</translation>
    </message>
</context>
<context>
    <name>driftbench::DevicePanel</name>
    <message>
        <source>On the device now against what would be written</source>
        <translation>设备现有补偿表与待写入补偿表</translation>
    </message>
    <message>
        <source>%1 of %2 B</source>
        <translation>%1/%2 B</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Activating and checking</source>
        <translation>正在激活并检验</translation>
    </message>
    <message>
        <source>Writing the spare bank</source>
        <translation>正在写入备用区</translation>
    </message>
    <message>
        <source>The table in use stays active until the last step.</source>
        <translation>最后一步之前，在用补偿表保持有效。</translation>
    </message>
    <message>
        <source>Write to the device</source>
        <translation>写入设备</translation>
    </message>
    <message>
        <source>Read back and verified. This device can&apos;t show its compensation at work.</source>
        <translation>已回读并校验。此设备无法显示其补偿的实际效果。</translation>
    </message>
    <message>
        <source>Rolled back: %1 of %2 samples differ from what the host computes, by up to %3 dps.</source>
        <translation>已回滚：%2 个样本中有 %1 个与主机计算不符，最大相差 %3 dps。</translation>
    </message>
    <message numerus="yes">
        <source>Verified at work: %n sample(s) compared with what the host computes, none differs.</source>
        <translation>
            <numerusform>已实际校验：%n 个样本与主机计算比较，全部相符。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Not written</source>
        <translation>未写入</translation>
    </message>
    <message>
        <source>The upload was cancelled.</source>
        <translation>上传已取消。</translation>
    </message>
    <message>
        <source>The table was not written.</source>
        <translation>补偿表未写入。</translation>
    </message>
    <message>
        <source>gen. %1</source>
        <translation>第 %1 代</translation>
    </message>
    <message>
        <source>bank %1</source>
        <translation>%1 区</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>已回滚</translation>
    </message>
    <message>
        <source>Bank %1 is in use</source>
        <translation>%1 区使用中</translation>
    </message>
    <message>
        <source>The new table was rolled back.</source>
        <translation>新补偿表已回滚。</translation>
    </message>
    <message>
        <source>The table is on the device.</source>
        <translation>补偿表已在设备上。</translation>
    </message>
    <message>
        <source>The table before was not restored.</source>
        <translation>先前的补偿表未能恢复。</translation>
    </message>
    <message>
        <source>Bank %1, generation %2, is in use again.</source>
        <translation>已重新启用 %1 区第 %2 代。</translation>
    </message>
    <message>
        <source>No table is in use any more; the device sends raw rates.</source>
        <translation>已无在用补偿表；设备发送原始角速率。</translation>
    </message>
    <message>
        <source>The table was taken out of use.</source>
        <translation>补偿表已停用。</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>此处未知</translation>
    </message>
    <message>
        <source>fixed point</source>
        <translation>定点</translation>
    </message>
    <message>
        <source>float32</source>
        <translation>float32</translation>
    </message>
    <message>
        <source>on the die</source>
        <translation>片内</translation>
    </message>
    <message>
        <source>external</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>Bank, generation</source>
        <translation>存储区，代</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Range, rows</source>
        <translation>范围，行数</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>CRC-32</source>
        <translation>CRC-32</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1, %2, active</source>
        <translation>%1，%2，有效</translation>
    </message>
    <message>
        <source>no image: see Files</source>
        <translation>无映像：见“文件”</translation>
    </message>
    <message>
        <source>On the device now</source>
        <translation>设备现有</translation>
    </message>
    <message>
        <source>Would be written</source>
        <translation>待写入</translation>
    </message>
    <message>
        <source>Device %1</source>
        <translation>设备 %1</translation>
    </message>
    <message>
        <source>%1, firmware %2, simulated</source>
        <translation>%1，固件 %2，仿真</translation>
    </message>
    <message>
        <source>%1, firmware %2</source>
        <translation>%1，固件 %2</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>No device chosen</source>
        <translation>未选择设备</translation>
    </message>
    <message>
        <source>Choose the simulated bridge or a plugged-in one as source.</source>
        <translation>请选择仿真桥接器或已插入的桥接器作为数据源。</translation>
    </message>
    <message>
        <source>No tables there</source>
        <translation>设备无补偿表</translation>
    </message>
    <message>
        <source>Looking at the device</source>
        <translation>正在查看设备</translation>
    </message>
    <message>
        <source>Bank %1 active</source>
        <translation>%1 区有效</translation>
    </message>
    <message>
        <source>No table active</source>
        <translation>无有效补偿表</translation>
    </message>
    <message>
        <source>%1, the spare bank being written</source>
        <translation>%1，正在写入备用区</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Activation not confirmed</source>
        <translation>激活未确认</translation>
    </message>
    <message>
        <source>Look at the device to see which table is in use.</source>
        <translation>请查看设备以确认在用的补偿表。</translation>
    </message>
    <message>
        <source>The table that was in use still is.</source>
        <translation>原在用补偿表仍在使用。</translation>
    </message>
    <message>
        <source>The activation was not confirmed.</source>
        <translation>激活未得到确认。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>推荐</translation>
    </message>
    <message>
        <source>%1 to %2 °C, %3</source>
        <translation>%1 至 %2 °C，%3</translation>
    </message>
</context>
<context>
    <name>driftbench::DurationField</name>
    <message>
        <source>h:min:s</source>
        <translation>h:min:s</translation>
    </message>
</context>
<context>
    <name>driftbench::EventLog</name>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>driftbench::ExcludedModel</name>
    <message>
        <source>non-finite</source>
        <translation>非有限值</translation>
    </message>
    <message>
        <source>bad time</source>
        <translation>时间错误</translation>
    </message>
    <message>
        <source>start-up</source>
        <translation>启动段</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>饱和</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>temperature fault</source>
        <translation>温度故障</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>离群值</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>全程</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Time (%1)</source>
        <translation>时间 (%1)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
</context>
<context>
    <name>driftbench::ExclusionStrip</name>
    <message>
        <source>excluded</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>Drift error over time</source>
        <translation>漂移误差随时间变化</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>无样本</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>请采集一个测次，或打开日志文件。</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>升温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>已选</translation>
    </message>
</context>
<context>
    <name>driftbench::ExportPage</name>
    <message>
        <source>Table preview</source>
        <translation>补偿表预览</translation>
    </message>
    <message>
        <source>Recommended of each axis</source>
        <translation>各轴推荐模型</translation>
    </message>
    <message>
        <source>There is no table to write.</source>
        <translation>无可写入的补偿表。</translation>
    </message>
    <message>
        <source>The table for the device</source>
        <translation>设备的补偿表</translation>
    </message>
    <message>
        <source>Into the spare bank; the one in use stays until the end</source>
        <translation>写入备用区；在用补偿表保持到最后</translation>
    </message>
    <message>
        <source>There is no table to write</source>
        <translation>无可写入的补偿表</translation>
    </message>
    <message>
        <source>A table is being written</source>
        <translation>正在写入补偿表</translation>
    </message>
    <message>
        <source>No device with tables is there</source>
        <translation>无支持补偿表的设备</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>文件所在文件夹</translation>
    </message>
    <message>
        <source>The files were not written.</source>
        <translation>文件未写入。</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1.</source>
        <translation>
            <numerusform>%n 个文件已写入 %1。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written.</source>
        <translation>
            <numerusform>%n 个文件已写入。</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing, %1 %</source>
        <translation>写入中，%1 %</translation>
    </message>
    <message>
        <source>Table on %1</source>
        <translation>补偿表在 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written</source>
        <translation>
            <numerusform>%n 个文件已写入</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing written</source>
        <translation>未写入</translation>
    </message>
    <message>
        <source>Esc cancel, the old table stays · Ctrl+S save the files</source>
        <translation>Esc 取消，保留旧补偿表 · Ctrl+S 保存文件</translation>
    </message>
    <message>
        <source>Ctrl+S save the files · Ctrl+U write to the device · F5 look again · Ctrl+C copy the selected cells</source>
        <translation>Ctrl+S 保存文件 · Ctrl+U 写入设备 · F5 重新查找 · Ctrl+C 复制所选单元格</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>保存文件…</translation>
    </message>
    <message>
        <source>Write to device</source>
        <translation>写入设备</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Takes the table out of use; the one before it takes over</source>
        <translation>停用此补偿表，由上一补偿表接替</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>选择数据源</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>训练</translation>
    </message>
    <message>
        <source>No model yet</source>
        <translation>尚无模型</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>请先训练模型。</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Shown form</source>
        <translation>显示形式</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>文件预览</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>补偿表</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>C header</source>
        <translation>C 头文件</translation>
    </message>
    <message>
        <source>PX4</source>
        <translation>PX4</translation>
    </message>
    <message>
        <source>ArduPilot</source>
        <translation>ArduPilot</translation>
    </message>
    <message>
        <source>Device image</source>
        <translation>设备映像</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>重新查找</translation>
    </message>
    <message>
        <source>int32, 1 LSB = 2%1 dps = %2 µdps</source>
        <translation>int32，1 LSB = 2%1 dps = %2 µdps</translation>
    </message>
    <message>
        <source>Table of %1 rows, %2 °C apart.</source>
        <translation>%1 行，间隔 %2 °C</translation>
    </message>
    <message>
        <source>Axes without a yes are written too.</source>
        <translation>判定非“是”的轴也会写入。</translation>
    </message>
    <message>
        <source>Compare says what that costs on runs held out.</source>
        <translation>在留出测次上的代价见“比较”。</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>%1 没有补偿表。</translation>
    </message>
    <message>
        <source>It does not help on runs held out; Compare has the figures. Its values are zero.</source>
        <translation>它在留出测次上没有帮助；数据见“比较”。此处为零。</translation>
    </message>
</context>
<context>
    <name>driftbench::FileChoices</name>
    <message>
        <source>Largest interpolation error</source>
        <translation>最大插值误差</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>cubic, loses nothing</source>
        <translation>三次，无损失</translation>
    </message>
    <message>
        <source>cubic only: up to %1 mdps off on %2, %3 rms</source>
        <translation>仅三次：%2 最大偏差 %1 mdps，rms %3</translation>
    </message>
    <message>
        <source>%1 of %2 chosen</source>
        <translation>已选 %1/%2</translation>
    </message>
    <message numerus="yes">
        <source>table, %n row(s)</source>
        <translation>
            <numerusform>补偿表，%n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>table in both kinds and where it comes from, exact</source>
        <translation>两种类型的补偿表及其来源，精确</translation>
    </message>
    <message>
        <source>float and fixed point, %1 bytes</source>
        <translation>浮点与定点，%1 字节</translation>
    </message>
    <message>
        <source>one bank, %1 bytes</source>
        <translation>一个存储区，%1 字节</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>C header</source>
        <translation>C 头文件</translation>
    </message>
    <message>
        <source>PX4 .params</source>
        <translation>PX4 .params</translation>
    </message>
    <message>
        <source>ArduPilot .parm</source>
        <translation>ArduPilot .parm</translation>
    </message>
    <message>
        <source>Device image</source>
        <translation>设备映像</translation>
    </message>
    <message>
        <source>Also axes without a yes</source>
        <translation>包括判定非“是”的轴</translation>
    </message>
    <message>
        <source>Axes whose verdict is not yes are left out unless this is on; the files say so.</source>
        <translation>除非启用此项，判定非“是”的轴将略去；文件中有说明。</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>最大误差</translation>
    </message>
    <message>
        <source>PX4 device id</source>
        <translation>PX4 设备 id</translation>
    </message>
    <message>
        <source>By which PX4 knows the gyro again: its parameter TC_G0_ID. Empty: the serial number.</source>
        <translation>PX4 据此识别陀螺：其参数 TC_G0_ID。留空：用序列号。</translation>
    </message>
    <message>
        <source>needs the gyro&apos;s device id, below</source>
        <translation>需要下面的陀螺仪设备 ID</translation>
    </message>
    <message>
        <source>needs the sensor&apos;s name: state it when you open the log</source>
        <translation>需要传感器信息：打开日志时填写</translation>
    </message>
</context>
<context>
    <name>driftbench::FileSurvey</name>
    <message>
        <source>Span too small to fit</source>
        <translation>跨度过小，无法拟合</translation>
    </message>
    <message>
        <source>Temperature stands still</source>
        <translation>温度无变化</translation>
    </message>
    <message>
        <source>Too short to fit</source>
        <translation>过短，无法拟合</translation>
    </message>
    <message>
        <source>Can&apos;t be used as it is</source>
        <translation>目前不可用</translation>
    </message>
    <message>
        <source>No drift found</source>
        <translation>未发现漂移</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1：迟滞</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>Can&apos;t be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>Run %1 to do</source>
        <translation>待采集测次 %1</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>尚无测次</translation>
    </message>
    <message>
        <source>Ready to train</source>
        <translation>可训练</translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation>已不存在</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>未知格式</translation>
    </message>
    <message>
        <source>Large: looked at when opened</source>
        <translation>较大：打开时再查看</translation>
    </message>
    <message>
        <source>Can&apos;t be read</source>
        <translation>无法读取</translation>
    </message>
</context>
<context>
    <name>driftbench::I2cForm</name>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Whichever answers</source>
        <translation>任一应答者</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>陀螺</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>量程</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>采样率</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>温度计</translation>
    </message>
    <message>
        <source>Die offset</source>
        <translation>片内偏移</translation>
    </message>
    <message>
        <source>Bus speed</source>
        <translation>总线速率</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>外部，否则片内</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>片内</translation>
    </message>
    <message>
        <source>0 takes the gyro&apos;s usual rate.</source>
        <translation>0 表示采用陀螺的常用采样率。</translation>
    </message>
    <message>
        <source>Of the gyro&apos;s own thermometer, which only tells differences.</source>
        <translation>陀螺自带温度计的偏移；它只能反映温差。</translation>
    </message>
    <message>
        <source>which gyro it is</source>
        <translation>陀螺的标识</translation>
    </message>
    <message>
        <source>The gyro can&apos;t say it itself; it keeps runs of different gyros apart.</source>
        <translation>陀螺自身无法提供；用于区分不同陀螺的测次。</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectPage</name>
    <message>
        <source>What is plotted</source>
        <translation>绘图内容</translation>
    </message>
    <message>
        <source>name the reason</source>
        <translation>注明原因</translation>
    </message>
    <message>
        <source>Against TCQ</source>
        <translation>随 TCQ</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>随时间</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>检查结果</translation>
    </message>
    <message>
        <source>exclude %1 s of %2</source>
        <translation>剔除 %2 的 %1 s</translation>
    </message>
    <message>
        <source>include a stretch of %1</source>
        <translation>纳入 %1 的区段</translation>
    </message>
    <message>
        <source>move an excluded stretch of %1</source>
        <translation>移动 %1 的剔除区段</translation>
    </message>
    <message>
        <source>The plan can&apos;t be changed.</source>
        <translation>无法更改计划。</translation>
    </message>
    <message>
        <source>The runs are not read</source>
        <translation>测次未读取</translation>
    </message>
    <message>
        <source>Come back to this page to read them again.</source>
        <translation>返回此页可重新读取。</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>尚无测次</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>请采集一个测次，或打开日志文件。</translation>
    </message>
    <message>
        <source>The runs can&apos;t be read.</source>
        <translation>无法读取测次。</translation>
    </message>
    <message>
        <source>Reading the runs</source>
        <translation>正在读取测次</translation>
    </message>
    <message>
        <source>Fitted curve, ±1 σ of its residuals</source>
        <translation>拟合曲线，残差 ±1 σ</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE，%1 (dps)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <translation>%1，测次 %2</translation>
    </message>
    <message>
        <source>%1, runs %2</source>
        <translation>%1，测次 %2</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>升温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>TDE against the temperature quantities</source>
        <translation>TDE 随温度量的变化</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference from the holds</source>
        <translation>%1 的 TDE 随温度变化，参考取自保温段</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference %2 dps</source>
        <translation>%1 的 TDE 随温度变化，参考 %2 dps</translation>
    </message>
    <message>
        <source>heating again</source>
        <translation>再次升温</translation>
    </message>
    <message>
        <source>heating</source>
        <translation>升温</translation>
    </message>
    <message>
        <source>cooling again</source>
        <translation>再次降温</translation>
    </message>
    <message>
        <source>cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>%1 dps (%2)</source>
        <translation>%1 dps（%2）</translation>
    </message>
    <message>
        <source>These runs can&apos;t be calibrated as they are.</source>
        <translation>这些测次目前无法标定。</translation>
    </message>
    <message>
        <source>%1 is not a curve of temperature.</source>
        <translation>%1 不是温度的曲线。</translation>
    </message>
    <message>
        <source>No table over temperature can remove this.</source>
        <translation>任何温度补偿表都无法消除。</translation>
    </message>
    <message>
        <source>At %1 °C it reads %2.</source>
        <translation>在 %1 °C 处读数为 %2。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>至</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>发现</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>全程</translation>
    </message>
    <message>
        <source>Findings of the checks</source>
        <translation>检查结果列表</translation>
    </message>
    <message>
        <source>Include</source>
        <translation>纳入</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>剔除</translation>
    </message>
    <message>
        <source>Drag in the time strip to select a stretch first.</source>
        <translation>请先在时间条上拖动选取区段。</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>检查结果 (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n 个测次</numerusform>
        </translation>
    </message>
    <message>
        <source>Can&apos;t be calibrated</source>
        <translation>无法标定</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1：迟滞</translation>
    </message>
    <message>
        <source>Drag in the time strip to select · Delete exclude · Ctrl+Z undo · X, Y, Z choose the axis · Double-click fit</source>
        <translation>时间条上拖动 选取 · Delete 剔除 · Ctrl+Z 撤销 · X、Y、Z 选择轴 · 双击 适应窗口</translation>
    </message>
    <message>
        <source>%1, %2 samples at %3 Hz</source>
        <translation>%1，%2 个样本，%3 Hz</translation>
    </message>
    <message>
        <source>%1 excluded</source>
        <translation>已剔除 %1</translation>
    </message>
    <message numerus="yes">
        <source>exclude %1 s in %n stretches</source>
        <translation>
            <numerusform>剔除 %n 个区段共 %1 s</numerusform>
        </translation>
    </message>
    <message>
        <source>Each point is the mean of %1 samples</source>
        <translation>每个点是 %1 个样本的均值</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectSide</name>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>Excluded stretches</source>
        <translation>剔除区段</translation>
    </message>
    <message>
        <source>Swing of TDE</source>
        <translation>TDE 变化幅度</translation>
    </message>
    <message>
        <source>Noise within 0.5 °C</source>
        <translation>0.5 °C 内噪声</translation>
    </message>
    <message>
        <source>Left by the curve</source>
        <translation>曲线拟合残余</translation>
    </message>
    <message>
        <source>That is</source>
        <translation>相当于</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Heated and cooled</source>
        <translation>升温且降温</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>A curve of T</source>
        <translation>是 T 的曲线</translation>
    </message>
    <message>
        <source>Nearly a curve of T</source>
        <translation>近似 T 的曲线</translation>
    </message>
    <message>
        <source>Not a curve of T</source>
        <translation>非 T 的曲线</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>spread at %1 °C</source>
        <translation>%1 °C 处离散</translation>
    </message>
    <message>
        <source>swing</source>
        <translation>变化幅度</translation>
    </message>
    <message>
        <source>%1 in figures</source>
        <translation>%1 轴数据</translation>
    </message>
    <message>
        <source>%1 dps rms</source>
        <translation>%1 dps rms</translation>
    </message>
    <message>
        <source>%1 × the noise</source>
        <translation>噪声的 %1 倍</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1 至 %2 °C</translation>
    </message>
    <message>
        <source>%1 % of it</source>
        <translation>其中 %1 %</translation>
    </message>
</context>
<context>
    <name>driftbench::IntervalPanel</name>
    <message>
        <source>Smallest rate step, ΔE&lt;sub&gt;S&lt;/sub&gt;</source>
        <translation>最小角速率步长，ΔE&lt;sub&gt;S&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>Bias with T, γ′ = %1 × %2/%3</source>
        <translation>零偏随 T 变化，γ′ = %1 × %2/%3</translation>
    </message>
    <message>
        <source>mdps/°C</source>
        <translation>mdps/°C</translation>
    </message>
    <message>
        <source>Sensitivity with T, β</source>
        <translation>灵敏度随 T 变化，β</translation>
    </message>
    <message>
        <source>ΔE&lt;sub&gt;S&lt;/sub&gt; / (γ′ + β)</source>
        <translation>ΔE&lt;sub&gt;S&lt;/sub&gt; / (γ′ + β)</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>used, not above %1</source>
        <translation>采用值，不高于 %1</translation>
    </message>
    <message>
        <source>used, but above %1</source>
        <translation>采用值，但高于 %1</translation>
    </message>
    <message>
        <source>The paper prints β with the span squared, which gives %1 mdps/°C. Half the span gives the value it uses, %2.</source>
        <translation>论文中 β 按跨度平方印出，得 %1 mdps/°C。按半跨度则得其所用值 %2。</translation>
    </message>
</context>
<context>
    <name>driftbench::JudgedRunView</name>
    <message>
        <source>Held-out run before and after compensation, and its Allan deviation</source>
        <translation>留出测次补偿前后及其 Allan 偏差</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>补偿后，%1</translation>
    </message>
    <message>
        <source>After, %1 trained on %2</source>
        <translation>补偿后，%1，训练自 %2</translation>
    </message>
    <message>
        <source>Before, less the constant</source>
        <translation>补偿前，减常数</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>补偿前</translation>
    </message>
    <message>
        <source>Limit ±%1 dps</source>
        <translation>限值 ±%1 dps</translation>
    </message>
    <message>
        <source>TDE left (dps)</source>
        <translation>残余 TDE (dps)</translation>
    </message>
    <message>
        <source>Time in run</source>
        <translation>测次内时间</translation>
    </message>
    <message>
        <source>After</source>
        <translation>补偿后</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>平均时间 τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>最低：补偿前 %1，补偿后 %2 dps</translation>
    </message>
    <message>
        <source>No run to judge</source>
        <translation>无可评判的测次</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>请训练模型，并选择其未见过的测次。</translation>
    </message>
</context>
<context>
    <name>driftbench::KnotsTableModel</name>
    <message>
        <source>T
°C</source>
        <translation>T
°C</translation>
    </message>
    <message>
        <source>Worst
mdps</source>
        <translation>最差
mdps</translation>
    </message>
    <message>
        <source>%1
code</source>
        <translation>%1
码值</translation>
    </message>
    <message>
        <source>%1
dps</source>
        <translation>%1
dps</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveMarks</name>
    <message>
        <source>plateau</source>
        <translation>恒温段</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>%1: samples missing, %2</source>
        <translation>%1：缺少样本，%2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n samples dropped, %2</source>
        <translation>
            <numerusform>%1：丢失 %n 个样本，%2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::LiveRun</name>
    <message>
        <source>set the reference rate of the run that is recorded</source>
        <translation>设置当前采集测次的参考角速率</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveStrips</name>
    <message>
        <source>%1 comp.</source>
        <translation>%1 补偿后</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 原始</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveTraceView</name>
    <message>
        <source>Raw, mean and range</source>
        <translation>原始，均值与范围</translation>
    </message>
    <message>
        <source>Compensated</source>
        <translation>补偿后</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>时间 (s)</translation>
    </message>
    <message>
        <source>%1, lowest</source>
        <translation>%1，最低</translation>
    </message>
    <message>
        <source>%1, mean</source>
        <translation>%1，均值</translation>
    </message>
    <message>
        <source>%1, highest</source>
        <translation>%1，最高</translation>
    </message>
    <message>
        <source>%1 raw (dps)</source>
        <translation>%1 原始 (dps)</translation>
    </message>
    <message>
        <source>%1 compensated (dps)</source>
        <translation>%1 补偿后 (dps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>raw %1 dps</source>
        <translation>原始 %1 dps</translation>
    </message>
    <message>
        <source>compensated %1 dps</source>
        <translation>补偿后 %1 dps</translation>
    </message>
    <message>
        <source>T %1 °C</source>
        <translation>T %1 °C</translation>
    </message>
    <message>
        <source>plan %1 °C</source>
        <translation>计划 %1 °C</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>实时曲线</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>起始后时间 (h:min)</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>起始后时间 (h:min:s)</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>%1 角速率 (dps)</translation>
    </message>
    <message>
        <source>%1 TDE (dps)</source>
        <translation>%1 TDE (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::LoadingState</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
</context>
<context>
    <name>driftbench::LogForm</name>
    <message>
        <source>mdps/LSB</source>
        <translation>mdps/LSB</translation>
    </message>
    <message>
        <source>How</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Gyro in the log</source>
        <translation>日志中的陀螺</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>时间列</translation>
    </message>
    <message>
        <source>T column</source>
        <translation>T 列</translation>
    </message>
    <message>
        <source>x column</source>
        <translation>x 列</translation>
    </message>
    <message>
        <source>y column</source>
        <translation>y 列</translation>
    </message>
    <message>
        <source>z column</source>
        <translation>z 列</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>时间单位</translation>
    </message>
    <message>
        <source>T unit</source>
        <translation>T 单位</translation>
    </message>
    <message>
        <source>Rate unit</source>
        <translation>角速率单位</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>灵敏度</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>参考角速率</translation>
    </message>
    <message>
        <source>found by its name</source>
        <translation>按名称识别</translation>
    </message>
    <message>
        <source>The name in the header, or the number of the column.</source>
        <translation>表头中的名称，或列号。</translation>
    </message>
    <message>
        <source>Read in whole</source>
        <translation>整体读入</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Play back, %1 times</source>
        <translation>%1 倍速回放</translation>
    </message>
    <message>
        <source>The only one</source>
        <translation>唯一的一个</translation>
    </message>
    <message>
        <source>As the log says</source>
        <translation>以日志为准</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>as the log says</source>
        <translation>按日志</translation>
    </message>
    <message>
        <source>Whose log it is: a device takes a table only for itself, and the report names it.</source>
        <translation>日志属于哪个传感器：设备只接受自己的补偿表，报告也会注明。</translation>
    </message>
</context>
<context>
    <name>driftbench::MainWindow</name>
    <message>
        <source>Tab next · Enter choose · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>Tab 下一项 · Enter 选择 · Ctrl+O 打开文件 · Alt+1 至 7 步骤</translation>
    </message>
    <message>
        <source>Event log</source>
        <translation>事件日志</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>会话(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>新建会话(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open files…</source>
        <translation>打开文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近文件(&amp;R)</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>会话另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Copy the event log</source>
        <translation>复制事件日志</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>配色(&amp;C)</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全屏(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Event log</source>
        <translation>事件日志(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>起始页(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>导览(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>键盘快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Driftbench</source>
        <translation>关于 Driftbench(&amp;A)</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>关于 Qt(&amp;Q)</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>尚无文件</translation>
    </message>
    <message>
        <source>&amp;Save session…</source>
        <translation>保存会话(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>保存会话(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做(&amp;R)：%1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>全局</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Wheel|Zoom at the mouse; over an axis, that axis</source>
        <translation>滚轮|以鼠标处为中心缩放；在坐标轴上则缩放该轴</translation>
    </message>
    <message>
        <source>Drag|Move</source>
        <translation>拖动|平移</translation>
    </message>
    <message>
        <source>Shift+Drag|Zoom to a box</source>
        <translation>Shift+拖动|框选缩放</translation>
    </message>
    <message>
        <source>Double-click, F|Fit</source>
        <translation>双击、F|适应窗口</translation>
    </message>
    <message>
        <source>Arrows|Move</source>
        <translation>方向键|平移</translation>
    </message>
    <message>
        <source>+, −|Zoom</source>
        <translation>+、−|缩放</translation>
    </message>
    <message>
        <source>A, B|Set a cursor at the mouse</source>
        <translation>A、B|在鼠标处设置游标</translation>
    </message>
    <message>
        <source>Ctrl+E|Export what is visible</source>
        <translation>Ctrl+E|导出可见部分</translation>
    </message>
    <message>
        <source>About Driftbench</source>
        <translation>关于 Driftbench</translation>
    </message>
    <message>
        <source>Driftbench %1</source>
        <translation>Driftbench %1</translation>
    </message>
    <message>
        <source>Calibrates the temperature drift of MEMS gyros. Free software under the GNU General Public License, version 3 or later.</source>
        <translation>标定 MEMS 陀螺的温度漂移。自由软件，依据 GNU 通用公共许可证第 3 版或更高版本发布。</translation>
    </message>
    <message>
        <source>Open logs or a session</source>
        <translation>打开日志或会话</translation>
    </message>
    <message>
        <source>Logs and sessions (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;All files (*)</source>
        <translation>日志和会话 (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>保存会话</translation>
    </message>
    <message>
        <source>Sessions (*.driftbench)</source>
        <translation>会话 (*.driftbench)</translation>
    </message>
    <message>
        <source>New session, not saved yet</source>
        <translation>新会话，尚未保存</translation>
    </message>
    <message>
        <source>Unnamed session</source>
        <translation>未命名会话</translation>
    </message>
    <message>
        <source>Session: %1</source>
        <translation>会话：%1</translation>
    </message>
    <message>
        <source>%1 · read-only</source>
        <translation>%1 · 只读</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · 已保存</translation>
    </message>
    <message>
        <source>%1 · not saved</source>
        <translation>%1 · 未保存</translation>
    </message>
    <message>
        <source>Driftbench</source>
        <translation>Driftbench</translation>
    </message>
    <message>
        <source>%1 – Driftbench</source>
        <translation>%1 – Driftbench</translation>
    </message>
    <message>
        <source>Gap from %1 to %2 s: %3.</source>
        <translation>%1 至 %2 s 有间断：%3。</translation>
    </message>
    <message>
        <source>Session restored.</source>
        <translation>会话已恢复。</translation>
    </message>
    <message>
        <source>Recording stopped when the program ended. %1 samples are safe.</source>
        <translation>程序终止时采集已停止。%1 个样本完好。</translation>
    </message>
    <message>
        <source>It has no name yet; Save gives it one.</source>
        <translation>会话尚未命名；保存时可命名。</translation>
    </message>
    <message>
        <source>Quit Driftbench</source>
        <translation>退出 Driftbench</translation>
    </message>
    <message>
        <source>A run is being recorded.</source>
        <translation>正在采集测次。</translation>
    </message>
    <message>
        <source>The last changes are not on the disk.</source>
        <translation>最近的更改尚未存盘。</translation>
    </message>
    <message>
        <source>Quit ends the run. What was recorded is kept.</source>
        <translation>退出将结束测次。已采集的数据会保留。</translation>
    </message>
    <message>
        <source>Make room or permit the file to be written, then save again.</source>
        <translation>请腾出空间或允许写入文件，然后再次保存。</translation>
    </message>
    <message>
        <source>End the run and quit</source>
        <translation>结束测次并退出</translation>
    </message>
    <message>
        <source>Quit and lose them</source>
        <translation>退出并放弃更改</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>%1 is running.</source>
        <extracomment>%1 is the name of a source</extracomment>
        <translation>%1 正在采集。</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelLabels</name>
    <message>
        <source>RBF network</source>
        <translation>RBF 网络</translation>
    </message>
    <message>
        <source>RBF network, as in the paper</source>
        <translation>论文 RBF 网络</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>BP 网络</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>三次多项式</translation>
    </message>
    <message>
        <source>cubic, as ArduPilot</source>
        <translation>三次多项式，同 ArduPilot</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>常数</translation>
    </message>
    <message>
        <source>recommended model of each axis</source>
        <translation>各轴推荐模型</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelWords</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>RBF network (Novel)</source>
        <translation>RBF 网络（新型）</translation>
    </message>
    <message>
        <source>BP 2-%1-1 (Conv. 2)</source>
        <translation>BP 2-%1-1（常规 2）</translation>
    </message>
    <message>
        <source>Cubic (PX4)</source>
        <translation>三次（PX4）</translation>
    </message>
    <message>
        <source>Cubic (ArduPilot)</source>
        <translation>三次（ArduPilot）</translation>
    </message>
    <message>
        <source>Line (Conv. 1)</source>
        <translation>直线（常规 1）</translation>
    </message>
    <message>
        <source>Constant (bias only)</source>
        <translation>常数（仅零偏）</translation>
    </message>
    <message numerus="yes">
        <source>%n centres</source>
        <translation>
            <numerusform>%n 个中心</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 to %2 centres</source>
        <translation>%1 至 %2 个中心</translation>
    </message>
    <message>
        <source>RBF, %1 (Novel)</source>
        <translation>RBF，%1（新型）</translation>
    </message>
    <message>
        <source>RBF, paper (Novel)</source>
        <translation>论文 RBF（新型）</translation>
    </message>
    <message>
        <source>RBF, paper, %1</source>
        <translation>论文 RBF，%1</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelsTableModel</name>
    <message>
        <source>&lt; 1 ms</source>
        <translation>&lt; 1 ms</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Noise floor</source>
        <translation>本底噪声</translation>
    </message>
    <message>
        <source>Excess %1
%</source>
        <translation>超出量 %1
%</translation>
    </message>
    <message>
        <source>MSD %1
dps²</source>
        <translation>MSD %1
dps²</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
</context>
<context>
    <name>driftbench::MsdTrendView</name>
    <message>
        <source>MSD so far</source>
        <translation>当前 MSD</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>尚无数据</translation>
    </message>
    <message>
        <source>It begins with the recording.</source>
        <translation>随采集开始。</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>起始后时间 (h:min:s)</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>起始后时间 (h:min)</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>补偿前 %1</translation>
    </message>
    <message>
        <source>%1 after</source>
        <translation>补偿后 %1</translation>
    </message>
</context>
<context>
    <name>driftbench::NativeForm</name>
    <message>
        <source>As it is set</source>
        <translation>按当前设置</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>采样率</translation>
    </message>
    <message>
        <source>0 leaves the rate that the bridge has now.</source>
        <translation>0 表示保留桥接器当前的采样率。</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>量程</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>温度计</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>外部，否则片内</translation>
    </message>
    <message>
        <source>External</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>片内</translation>
    </message>
    <message>
        <source>Compensated by its own table</source>
        <translation>由自带补偿表补偿</translation>
    </message>
    <message>
        <source>To check a table that was written. A calibration needs raw rates.</source>
        <translation>用于检验已写入的补偿表。标定需要原始角速率。</translation>
    </message>
</context>
<context>
    <name>driftbench::OriginChip</name>
    <message>
        <source>Simulated data</source>
        <translation>仿真数据</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>实测日志</translation>
    </message>
    <message>
        <source>Real device</source>
        <translation>真实设备</translation>
    </message>
</context>
<context>
    <name>driftbench::PeriodPanel</name>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>As printed (kJ, °C)</source>
        <translation>按原文 (kJ, °C)</translation>
    </message>
    <message>
        <source>In SI, °C; in SI, kelvin</source>
        <translation>SI 制，°C；SI 制，开尔文</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>Slowest mode of a %1 m cube, still air</source>
        <translation>%1 m 立方体的最慢模态，静止空气</translation>
    </message>
</context>
<context>
    <name>driftbench::PlanForm</name>
    <message>
        <source>mdps/LSB</source>
        <translation>mdps/LSB</translation>
    </message>
    <message>
        <source>dps/°C</source>
        <translation>dps/°C</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Chamber</source>
        <translation>温箱</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>温度剖面</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>量程</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>灵敏度</translation>
    </message>
    <message>
        <source>Bias with T</source>
        <translation>零偏随 T</translation>
    </message>
    <message>
        <source>Inner length</source>
        <translation>内部边长</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>温度计</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>从、至</translation>
    </message>
    <message>
        <source>Lowest temperature</source>
        <translation>最低温度</translation>
    </message>
    <message>
        <source>Highest temperature</source>
        <translation>最高温度</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>Hold at the ends</source>
        <translation>两端保温</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>Come back down, to see hysteresis</source>
        <translation>返程降温，以观察迟滞</translation>
    </message>
    <message>
        <source>Own figures</source>
        <translation>自定数值</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Sensor preset</source>
        <translation>传感器预设</translation>
    </message>
    <message>
        <source>Chamber preset</source>
        <translation>温箱预设</translation>
    </message>
</context>
<context>
    <name>driftbench::PlanPage</name>
    <message>
        <source>edit of the plan</source>
        <translation>编辑计划</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1 至 %2 °C</translation>
    </message>
    <message>
        <source>None, from a log</source>
        <translation>无，来自日志</translation>
    </message>
    <message>
        <source>Tab next field · Up, Down change a value · Ctrl+Z undo · Ctrl+Enter record</source>
        <translation>Tab 下一字段 · ↑、↓ 改变数值 · Ctrl+Z 撤销 · Ctrl+Enter 采集</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>采用此计划</translation>
    </message>
    <message>
        <source>Plan file</source>
        <translation>计划文件</translation>
    </message>
    <message>
        <source>Open plan…</source>
        <translation>打开计划…</translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation>保存计划…</translation>
    </message>
    <message>
        <source>Save steps for a chamber controller…</source>
        <translation>保存温箱控制器的阶梯程序…</translation>
    </message>
    <message>
        <source>Save ramps for a chamber controller…</source>
        <translation>保存温箱控制器的斜坡程序…</translation>
    </message>
    <message>
        <source>One run</source>
        <translation>单个测次</translation>
    </message>
    <message>
        <source>Control interval</source>
        <translation>控制间隔</translation>
    </message>
    <message>
        <source>Eqs. 13, 14, 26, 27</source>
        <translation>式 13、14、26、27</translation>
    </message>
    <message>
        <source>Control period</source>
        <translation>控制周期</translation>
    </message>
    <message>
        <source>Eqs. 25, 28, and the transient</source>
        <translation>式 25、28 及瞬态</translation>
    </message>
    <message>
        <source>, without cooling back</source>
        <translation>，不含返程降温</translation>
    </message>
    <message>
        <source>What the chamber does in each run, and for how long</source>
        <translation>温箱在每个测次中的动作与时长</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>A step of %1 is shorter than still air needs to settle: %2.</source>
        <translation>%1 的步长短于静止空气的稳定时间：%2。</translation>
    </message>
    <message>
        <source>Stir the air, or place the thermometer on the sensor.</source>
        <translation>请搅动空气，或将温度计置于传感器上。</translation>
    </message>
    <message>
        <source>Open plan</source>
        <translation>打开计划</translation>
    </message>
    <message>
        <source>Plans (*.json)</source>
        <translation>计划 (*.json)</translation>
    </message>
    <message>
        <source>Plan read from %1.</source>
        <translation>计划已从 %1 读入。</translation>
    </message>
    <message>
        <source>Save plan</source>
        <translation>保存计划</translation>
    </message>
    <message>
        <source>Plan written to %1.</source>
        <translation>计划已写入 %1。</translation>
    </message>
    <message>
        <source>Save controller file</source>
        <translation>保存控制器文件</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Controller file written to %1.</source>
        <translation>控制器文件已写入 %1。</translation>
    </message>
    <message numerus="yes">
        <source>%1 a run, %2 samples at %3 Hz · %4 for %n runs</source>
        <translation>
            <numerusform>每测次 %1，%3 Hz 下 %2 个样本 · %n 个测次共 %4</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::PlotInteraction</name>
    <message>
        <source>Fit</source>
        <translation>适应窗口</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Set cursor A here</source>
        <translation>在此设置游标 A</translation>
    </message>
    <message>
        <source>Set cursor B here</source>
        <translation>在此设置游标 B</translation>
    </message>
    <message>
        <source>Remove the cursors</source>
        <translation>移除游标</translation>
    </message>
    <message>
        <source>Export what is visible…</source>
        <translation>导出可见部分…</translation>
    </message>
    <message>
        <source>Show the data as a table</source>
        <translation>以表格显示数据</translation>
    </message>
    <message>
        <source>Export what is visible</source>
        <translation>导出可见部分</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG 图形 (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV 表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>driftbench::PlotTable</name>
    <message>
        <source>Panel</source>
        <translation>子图</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>自变量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
</context>
<context>
    <name>driftbench::ProfileView</name>
    <message>
        <source>Set points of one run over time</source>
        <translation>单个测次的设定值随时间变化</translation>
    </message>
    <message>
        <source>hold %1</source>
        <translation>保温 %1</translation>
    </message>
    <message>
        <source>No profile</source>
        <translation>无温度剖面</translation>
    </message>
    <message>
        <source>Put the fields right that are marked.</source>
        <translation>请更正已标出的字段。</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>起始后时间</translation>
    </message>
    <message>
        <source>Set point (°C)</source>
        <translation>设定值 (°C)</translation>
    </message>
    <message numerus="yes">
        <source>%n steps of %1 °C, %2 °C/min</source>
        <translation>
            <numerusform>%n 步，每步 %1 °C，%2 °C/min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RateFields</name>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>Reference rate, %1</source>
        <translation>参考角速率，%1</translation>
    </message>
</context>
<context>
    <name>driftbench::RecentFilesModel</name>
    <message>
        <source>Ready to train</source>
        <translation>可训练</translation>
    </message>
    <message>
        <source>Single run</source>
        <translation>单个测次</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Real</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>查看中…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Expect</source>
        <translation>预期</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n runs</source>
        <translation>
            <numerusform>%1/%n 个测次</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n runs</source>
        <translation>
            <numerusform>%n 个测次</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RecordPage</name>
    <message>
        <source>Span of the traces</source>
        <translation>曲线的时间跨度</translation>
    </message>
    <message>
        <source>Quantity of the traces</source>
        <translation>曲线的显示量</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>开始采集</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>停止采集</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>选择数据源</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Write again</source>
        <translation>重新写入</translation>
    </message>
    <message>
        <source>Save it elsewhere…</source>
        <translation>另存到别处…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>10 min</source>
        <translation>10 min</translation>
    </message>
    <message>
        <source>1 min</source>
        <translation>1 min</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>角速率</translation>
    </message>
    <message>
        <source>TDE</source>
        <translation>TDE</translation>
    </message>
    <message>
        <source>No source is chosen.</source>
        <translation>未选择数据源。</translation>
    </message>
    <message>
        <source>Choose the bridge or the file to record from.</source>
        <translation>请选择用于采集的桥接器或文件。</translation>
    </message>
    <message>
        <source>The run can&apos;t be recorded.</source>
        <translation>无法采集此测次。</translation>
    </message>
    <message>
        <source>The source has ended.</source>
        <translation>数据源已结束。</translation>
    </message>
    <message>
        <source>Run %1 is complete.</source>
        <translation>测次 %1 已完成。</translation>
    </message>
    <message>
        <source>Run %1 was stopped at %2.</source>
        <translation>测次 %1 在 %2 处停止。</translation>
    </message>
    <message>
        <source>%1 samples are in the session.</source>
        <translation>会话中有 %1 个样本。</translation>
    </message>
    <message>
        <source>A part of the run is not on the disk.</source>
        <translation>测次的一部分未存盘。</translation>
    </message>
    <message>
        <source>It is kept in memory.</source>
        <translation>该部分保留在内存中。</translation>
    </message>
    <message>
        <source>The disk is slow.</source>
        <translation>磁盘缓慢。</translation>
    </message>
    <message>
        <source>The disk takes no more.</source>
        <translation>磁盘已无法写入。</translation>
    </message>
    <message>
        <source>Make room on it; recording goes on in memory.</source>
        <translation>请腾出磁盘空间；采集在内存中继续。</translation>
    </message>
    <message>
        <source>All samples are on the disk again.</source>
        <translation>全部样本已重新存盘。</translation>
    </message>
    <message>
        <source>The memory for samples is full, the run has ended.</source>
        <translation>样本内存已满，测次已结束。</translation>
    </message>
    <message>
        <source>Save what is not on the disk</source>
        <translation>保存未存盘的部分</translation>
    </message>
    <message>
        <source>CSV log (*.csv)</source>
        <translation>CSV 日志 (*.csv)</translation>
    </message>
    <message>
        <source>The rest of the run is in %1.</source>
        <translation>测次的其余部分在 %1 中。</translation>
    </message>
    <message>
        <source>The view is paused at %1. Recording goes on.</source>
        <translation>显示已在 %1 处暂停。采集继续。</translation>
    </message>
    <message>
        <source>%1 samples have arrived since. The figures on the right stay live.</source>
        <translation>此后又收到 %1 个样本。右侧数值仍实时更新。</translation>
    </message>
    <message>
        <source>The bridge was unplugged at %1.</source>
        <translation>桥接器在 %1 处被拔出。</translation>
    </message>
    <message>
        <source>Plug it in to go on with this run.</source>
        <translation>请插回以继续此测次。</translation>
    </message>
    <message>
        <source>No samples have come for %1 s.</source>
        <translation>已有 %1 s 未收到样本。</translation>
    </message>
    <message>
        <source>Look at the cable and the bridge; the run goes on as soon as they come again.</source>
        <translation>请检查电缆和桥接器；样本恢复后测次随即继续。</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>测次 %1/%2</translation>
    </message>
    <message>
        <source>%1, no model yet</source>
        <translation>%1，尚无模型</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1, compensated by the model of %2</source>
        <translation>%1，用 %2 的模型补偿</translation>
    </message>
    <message>
        <source>Resume view</source>
        <translation>恢复显示</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>暂停显示</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) in the session</source>
        <translation>
            <numerusform>会话中有 %n 个测次</numerusform>
        </translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>尚无测次</translation>
    </message>
    <message>
        <source>Record the next run from: %1.</source>
        <translation>下一测次的数据源：%1。</translation>
    </message>
    <message>
        <source>Choose a source, then record a run.</source>
        <translation>请选择数据源，然后采集一个测次。</translation>
    </message>
    <message>
        <source>%1 · %2 %</source>
        <translation>%1 · %2 %</translation>
    </message>
    <message>
        <source>Opening the source</source>
        <translation>正在打开数据源</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n 个测次</numerusform>
        </translation>
    </message>
    <message>
        <source>Space resume the view · Wheel zoom · Drag pan · A, B set a cursor at the mouse</source>
        <translation>Space 恢复显示 · 滚轮 缩放 · 拖动 平移 · A、B 在鼠标处设置游标</translation>
    </message>
    <message>
        <source>Wheel zoom · Drag pan · Shift+drag box zoom · Double-click fit · A, B set a cursor at the mouse</source>
        <translation>滚轮 缩放 · 拖动 平移 · Shift+拖动 框选缩放 · 双击 适应窗口 · A、B 在鼠标处设置游标</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
</context>
<context>
    <name>driftbench::RecordReadouts</name>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>测次进度</translation>
    </message>
    <message>
        <source>Running MSD</source>
        <translation>累计 MSD</translation>
    </message>
    <message>
        <source>dps², since 0:00:00</source>
        <translation>dps²，自 0:00:00 起</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>游标</translation>
    </message>
    <message>
        <source>10 s means, dps</source>
        <translation>10 s 均值，dps</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>MSD so far</source>
        <translation>当前 MSD</translation>
    </message>
    <message>
        <source>dps², amber before, blue after</source>
        <translation>dps²，琥珀色补偿前，蓝色补偿后</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>已用时间</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>剩余时间</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>before</source>
        <translation>补偿前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>补偿后</translation>
    </message>
    <message>
        <source>Q = after/before</source>
        <translation>Q = 补偿后/补偿前</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 原始</translation>
    </message>
    <message>
        <source>%1 comp.</source>
        <translation>%1 补偿后</translation>
    </message>
    <message>
        <source>Sample rate, samples</source>
        <translation>采样率，样本数</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>Overruns, saturated</source>
        <translation>溢出，饱和</translation>
    </message>
    <message>
        <source>rise, step %1 of %2</source>
        <translation>升温，第 %1/%2 步</translation>
    </message>
    <message>
        <source>fall, step %1 of %2</source>
        <translation>降温，第 %1/%2 步</translation>
    </message>
    <message>
        <source>hold, step %1 of %2</source>
        <translation>保温，第 %1/%2 步</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1，偏差 %2</translation>
    </message>
    <message>
        <source>%1, %2 ahead</source>
        <translation>%1，超前 %2</translation>
    </message>
    <message>
        <source>%1, %2 behind</source>
        <translation>%1，落后 %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>恒温段</translation>
    </message>
    <message>
        <source>rms of 10 s means, before and after:</source>
        <translation>10 s 均值的 rms，补偿前和补偿后：</translation>
    </message>
    <message>
        <source>%1: %2 and %3 dps</source>
        <translation>%1：%2 和 %3 dps</translation>
    </message>
    <message>
        <source>last gap %1</source>
        <translation>最近间断 %1</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
</context>
<context>
    <name>driftbench::ReportText</name>
    <message>
        <source>%1 trained on other runs</source>
        <translation>%1，训练自其他测次</translation>
    </message>
    <message>
        <source>%1 trained on %2</source>
        <translation>%1，训练自 %2</translation>
    </message>
    <message>
        <source>Temperature quantities and drift error over time</source>
        <translation>温度量与漂移误差随时间变化</translation>
    </message>
    <message>
        <source>Run %1: ΔT, ΔT² and √ΔT, and the temperature drift error (TDE) of each axis.</source>
        <translation>测次 %1：ΔT、ΔT² 和 √ΔT，以及各轴的温度漂移误差 (TDE)。</translation>
    </message>
    <message>
        <source>TDE of %1 against each temperature quantity</source>
        <translation>%1 的 TDE 随各温度量的变化</translation>
    </message>
    <message>
        <source>All runs, with the curves fitted to them; below, what the fitted curve leaves. Where heating and cooling part, no curve of temperature follows.</source>
        <translation>全部测次及其拟合曲线；下方为拟合曲线的残余。升温与降温分开之处，温度的任何曲线都无法跟随。</translation>
    </message>
    <message>
        <source>Run %1 before and after compensation</source>
        <translation>测次 %1 补偿前后</translation>
    </message>
    <message>
        <source>The model has not seen this run. Mean, and lowest to highest, of each stretch of time; rms about the reference rate.</source>
        <translation>模型未见过此测次。图示各时间段的均值及最低至最高值；rms 相对于参考角速率。</translation>
    </message>
    <message>
        <source>Allan deviation of run %1</source>
        <translation>测次 %1 的 Allan 偏差</translation>
    </message>
    <message>
        <source>Noise falls with the averaging time, drift rises with it.</source>
        <translation>噪声随平均时间下降，漂移随之上升。</translation>
    </message>
    <message>
        <source>Run %1, held out: what is left, and its Allan deviation</source>
        <translation>留出测次 %1：残余及其 Allan 偏差</translation>
    </message>
    <message>
        <source>Before, less the constant; after, by a model that has not seen this run. Each axis has its own scale.</source>
        <translation>补偿前，减常数；补偿后，用未见过此测次的模型。各轴刻度不同。</translation>
    </message>
    <message>
        <source>What is left of the TDE on runs held out</source>
        <translation>留出测次上的残余 TDE</translation>
    </message>
    <message>
        <source>Each run less the model that has not seen it. Lines that are level at zero mean that the drift repeats.</source>
        <translation>各测次减去未见过它的模型。曲线平直于零，表示漂移可重复。</translation>
    </message>
    <message>
        <source>How many centres the RBF network needs</source>
        <translation>RBF 网络所需的中心数</translation>
    </message>
    <message>
        <source>The smallest number whose loss on data left out is as good as the lowest; below, where the centres stand.</source>
        <translation>留出数据上的损失与最低值相当的最小数目；下方为各中心的位置。</translation>
    </message>
    <message>
        <source>Simulated data</source>
        <translation>仿真数据</translation>
    </message>
    <message>
        <source>%1 held out</source>
        <translation>留出 %1</translation>
    </message>
    <message>
        <source>Blocks of temperature held out in turn</source>
        <translation>温度块逐块留出</translation>
    </message>
    <message>
        <source>Each run held out once</source>
        <translation>各测次逐次留出</translation>
    </message>
    <message>
        <source>Anchored: the bias at the start of each run is removed</source>
        <translation>锚定：去除各测次开始时的零偏</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts</source>
        <translation>绝对：计入启动零偏</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>not stated by the logs</source>
        <translation>日志未注明</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Date of this report</source>
        <translation>报告日期</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>%1, with %2 samples, %3 of them usable</source>
        <translation>%1，样本 %2 个，其中可用 %3 个</translation>
    </message>
    <message>
        <source>Reference temperature</source>
        <translation>参考温度</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Hold-out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>评判</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>%1 dps rms may be left on a held-out run</source>
        <translation>留出测次上允许残余 %1 dps rms</translation>
    </message>
    <message>
        <source>none was set</source>
        <translation>未设置</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Where the data come from</source>
        <translation>数据出处</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>数据源</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Reference dps</source>
        <translation>参考 dps</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>可用</translation>
    </message>
    <message>
        <source>Left out, and why</source>
        <translation>略去部分及原因</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Means over the held-out runs.</source>
        <translation>各留出测次的均值。</translation>
    </message>
    <message>
        <source>Held-out runs, in the paper&apos;s order</source>
        <translation>留出测次，按论文顺序</translation>
    </message>
    <message>
        <source>MSD in dps²: mean square of what is left. Q: MSD after over MSD before. Differences: negative where the first named is better. Novel: %1.</source>
        <translation>MSD 单位 dps²：残余的均方值。Q：补偿后 MSD 与补偿前 MSD 之比。差值：为负表示前者较优。新型：%1。</translation>
    </message>
    <message>
        <source>Conventional 1 is a line in ΔT, Conventional 2 a BP network 2-10-1, Novel an RBF network on ΔT, ΔT² and √ΔT; cubic is the model of PX4 and ArduPilot, constant the bias alone.</source>
        <translation>常规 1 为 ΔT 的直线，常规 2 为 BP 网络 2-10-1，新型为以 ΔT、ΔT² 和 √ΔT 为输入的 RBF 网络；三次为 PX4 和 ArduPilot 的模型，常数仅含零偏。</translation>
    </message>
    <message>
        <source>Yes: within the limit and better than the constant on every held-out run. With care: within the limit, but not always better. No: over the limit on any run, or the bias does not repeat.</source>
        <translation>是：在每个留出测次上均不超限值且优于常数。慎用：不超限值，但并非总是更优。否：任一测次超出限值，或零偏不可重复。</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>实测日志</translation>
    </message>
    <message>
        <source>unknown sensor</source>
        <translation>未知传感器</translation>
    </message>
    <message>
        <source>Temperature drift of %1, simulated</source>
        <translation>%1 的温度漂移，仿真</translation>
    </message>
    <message>
        <source>Temperature drift of %1</source>
        <translation>%1 的温度漂移</translation>
    </message>
    <message>
        <source>May this drift be compensated?</source>
        <translation>此漂移可否补偿？</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>第 %1 页</translation>
    </message>
    <message>
        <source>Each model estimates the rate error as a function of temperature alone and is judged only on runs that it has not seen. %1. The noise floor is the variance within 0.5 °C: what no function of temperature removes. Excess is what a model leaves above it.</source>
        <translation>各模型将角速率误差仅作为温度的函数来估计，且只在其未见过的测次上评判。%1。本底噪声为 0.5 °C 内的方差：温度的任何函数都无法消除。超出量为模型在其之上的残余。</translation>
    </message>
</context>
<context>
    <name>driftbench::ReportWriter</name>
    <message>
        <source>Preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>Drawing figure %1 of %2</source>
        <translation>正在绘图，%1/%2</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>写入中</translation>
    </message>
</context>
<context>
    <name>driftbench::ResidualView</name>
    <message>
        <source>Residual against temperature</source>
        <translation>残差随温度变化</translation>
    </message>
    <message>
        <source>No residuals yet</source>
        <translation>尚无残差</translation>
    </message>
    <message>
        <source>Train a model and choose runs that it has not seen.</source>
        <translation>请训练模型，并选择其未见过的测次。</translation>
    </message>
    <message>
        <source>Mean over 1 °C, each run</source>
        <translation>每 1 °C 均值，各测次</translation>
    </message>
    <message>
        <source>95 % band of a new run&apos;s curve</source>
        <translation>新测次曲线的 95 % 带</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Residual (dps)</source>
        <translation>残差 (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::ScatterDots</name>
    <message>
        <source>Heating</source>
        <translation>升温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>已剔除</translation>
    </message>
</context>
<context>
    <name>driftbench::Session</name>
    <message>
        <source>unnamed</source>
        <translation>未命名</translation>
    </message>
</context>
<context>
    <name>driftbench::ShortcutOverview</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>功能</translation>
    </message>
</context>
<context>
    <name>driftbench::SimulatedForm</name>
    <message>
        <source>Curved</source>
        <translation>弯曲</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>陡峭</translation>
    </message>
    <message>
        <source>Mild</source>
        <translation>平缓</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Combs</source>
        <translation>梳齿</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>As fast as it goes</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 倍速</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>参考角速率</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>采样率</translation>
    </message>
    <message>
        <source>Noise, 1 σ</source>
        <translation>噪声，1 σ</translation>
    </message>
    <message>
        <source>Run-to-run spread</source>
        <translation>测次间离散</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>How fast the simulated time passes while a run is recorded.</source>
        <translation>采集测次时仿真时间流逝的快慢。</translation>
    </message>
    <message>
        <source>How the bias follows the temperature; Combs computes it from the comb capacitors.</source>
        <translation>零偏随温度变化的方式；“梳齿”由梳齿电容计算。</translation>
    </message>
    <message>
        <source>%1, %2 dps</source>
        <translation>%1，%2 dps</translation>
    </message>
    <message>
        <source>%1, drift: %2</source>
        <translation>%1，漂移：%2</translation>
    </message>
</context>
<context>
    <name>driftbench::SourceForm</name>
    <message>
        <source>No source chosen</source>
        <translation>未选择数据源</translation>
    </message>
</context>
<context>
    <name>driftbench::SourcePage</name>
    <message>
        <source>Reading</source>
        <translation>读取中</translation>
    </message>
    <message>
        <source>Reading logs</source>
        <translation>正在读取日志</translation>
    </message>
    <message>
        <source>Simulated bridge</source>
        <translation>仿真桥接器</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>陀螺桥接器</translation>
    </message>
    <message>
        <source>I2C bridge</source>
        <translation>I2C 桥接器</translation>
    </message>
    <message>
        <source>Up, Down choose · Enter use · F5 look again · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>↑、↓ 选择 · Enter 采用 · F5 重新查找 · Ctrl+O 打开文件 · Alt+1 至 7 步骤</translation>
    </message>
    <message>
        <source>%1 %2 is plugged in, but you may not open it.</source>
        <translation>%1 %2 已插入，但无权打开。</translation>
    </message>
    <message>
        <source>Save this line as 70-driftbench.rules in /etc/udev/rules.d, then unplug the bridge and plug it in again:</source>
        <translation>请将此行保存为 /etc/udev/rules.d 中的 70-driftbench.rules，然后拔出桥接器并重新插入：</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Use source</source>
        <translation>采用数据源</translation>
    </message>
    <message>
        <source>Choose a bridge or a file.</source>
        <translation>请选择桥接器或文件。</translation>
    </message>
    <message>
        <source>Use simulated bridge</source>
        <translation>采用仿真桥接器</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>采用 %1</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>打开会话</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Read in</source>
        <translation>读入</translation>
    </message>
    <message>
        <source>Other logs are being read.</source>
        <translation>正在读取其他日志。</translation>
    </message>
    <message>
        <source>A run is being recorded. Stop it to take another source.</source>
        <translation>正在采集测次。停止后方可改用其他数据源。</translation>
    </message>
    <message>
        <source>Where the samples come from. Nothing is recorded yet.</source>
        <translation>样本的来源。尚未采集。</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>重新查找</translation>
    </message>
    <message>
        <source>Copy line</source>
        <translation>复制该行</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>桥接器</translation>
    </message>
    <message>
        <source>USB-HID, looked for every second</source>
        <translation>USB-HID，每秒查找一次</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近文件</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>最近 60 s</translation>
    </message>
    <message>
        <source>Drop log files here: CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>将日志文件拖放到此处：CSV、PX4 ULog、ArduPilot DataFlash。格式按内容识别。</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>尚无文件</translation>
    </message>
    <message>
        <source>Logs and sessions that were opened stand here.</source>
        <translation>打开过的日志和会话列于此处。</translation>
    </message>
    <message numerus="yes">
        <source>%n logs</source>
        <translation>
            <numerusform>%n 份日志</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bridges plugged in, %1 usable</source>
        <translation>
            <numerusform>已插入 %n 个桥接器，%1 个可用</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Where the samples come from. %n runs so far.</source>
        <translation>
            <numerusform>样本的来源。已有 %n 个测次。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::SourceStatus</name>
    <message>
        <source> · opening</source>
        <translation> · 打开中</translation>
    </message>
    <message>
        <source> · no samples for %1 s</source>
        <translation> · 已 %1 s 无样本</translation>
    </message>
    <message>
        <source> · %1 Hz</source>
        <translation> · %1 Hz</translation>
    </message>
    <message>
        <source> · 0 dropped</source>
        <translation> · 丢失 0</translation>
    </message>
    <message>
        <source>%1 dropped of %2</source>
        <translation>%2 中丢失 %1</translation>
    </message>
    <message>
        <source>%1 GB free</source>
        <translation>剩余 %1 GB</translation>
    </message>
</context>
<context>
    <name>driftbench::StartPage</name>
    <message>
        <source>Calibrate the temperature drift of a gyro</source>
        <translation>标定陀螺的温度漂移</translation>
    </message>
    <message>
        <source>From samples to a table in the device, in seven steps. Each step can be used on its own.</source>
        <translation>从样本到设备中的补偿表，共七步。每一步均可单独使用。</translation>
    </message>
    <message>
        <source>Guided tour on the simulated bridge</source>
        <translation>仿真桥接器导览</translation>
    </message>
    <message>
        <source>Connects, records three runs faster than time, trains, compares and writes the table. Under two minutes, no hardware.</source>
        <translation>连接，以快于实时的速度采集三个测次，训练，比较并写入补偿表。不到两分钟，无需硬件。</translation>
    </message>
    <message>
        <source>Connect a bridge</source>
        <translation>连接桥接器</translation>
    </message>
    <message>
        <source>A native gyro bridge, or an L3GD20H or I3G4250D behind a USB-to-I2C chip.</source>
        <translation>原生陀螺桥接器，或 USB 转 I2C 芯片后的 L3GD20H 或 I3G4250D。</translation>
    </message>
    <message>
        <source>Open log files or a session…</source>
        <translation>打开日志文件或会话…</translation>
    </message>
    <message>
        <source>CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>CSV、PX4 ULog、ArduPilot DataFlash。格式按内容识别。</translation>
    </message>
    <message>
        <source>Files can also be dropped anywhere on this window. F1 lists all keys.</source>
        <translation>文件也可拖放到窗口任意处。F1 列出全部按键。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
</context>
<context>
    <name>driftbench::StepRail</name>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>有警告</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>采集中</translation>
    </message>
    <message>
        <source>working</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>%1 (Alt+%2)</source>
        <translation>%1 (Alt+%2)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
</context>
<context>
    <name>driftbench::StripView</name>
    <message>
        <source>The last minute of the source</source>
        <translation>数据源的最近一分钟</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Nothing comes yet</source>
        <translation>尚无数据</translation>
    </message>
    <message>
        <source>Choose a source at the left.</source>
        <translation>请在左侧选择数据源。</translation>
    </message>
    <message>
        <source>Time before now (s)</source>
        <translation>距当前时间 (s)</translation>
    </message>
</context>
<context>
    <name>driftbench::TableDifferenceView</name>
    <message>
        <source>New table less the one on the device</source>
        <translation>新补偿表减设备现有补偿表</translation>
    </message>
    <message>
        <source>Nothing to compare</source>
        <translation>无可比较内容</translation>
    </message>
    <message>
        <source>No table is on the device.</source>
        <translation>设备上无补偿表。</translation>
    </message>
    <message>
        <source>New − now (mdps)</source>
        <translation>新 − 现有 (mdps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::TableErrorView</name>
    <message>
        <source>Worst error of the table in each cell</source>
        <translation>补偿表在各区间的最差误差</translation>
    </message>
    <message>
        <source>Worst in each cell</source>
        <translation>各区间最差</translation>
    </message>
    <message>
        <source>worst %1 mdps</source>
        <translation>最差 %1 mdps</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>无补偿表</translation>
    </message>
    <message>
        <source>No table yet</source>
        <translation>尚无补偿表</translation>
    </message>
    <message>
        <source>Train a model to see what a table of it costs.</source>
        <translation>训练模型后可知其补偿表的精度损失。</translation>
    </message>
    <message>
        <source>Table against model</source>
        <translation>补偿表与模型之差</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>误差界</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Error (mdps)</source>
        <translation>误差 (mdps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::TcqScatterView</name>
    <message>
        <source>Drift error against the temperature quantities</source>
        <translation>漂移误差随温度量的变化</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>升温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>Fitted curve, %1, with its 95 % band</source>
        <translation>拟合曲线，%1，含 95 % 带</translation>
    </message>
    <message>
        <source>Fitted curve, %1</source>
        <translation>拟合曲线，%1</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>已选</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>无样本</translation>
    </message>
    <message>
        <source>All samples are excluded, or no run was given.</source>
        <translation>全部样本已剔除，或未给出测次。</translation>
    </message>
    <message>
        <source>ΔT (°C)</source>
        <translation>ΔT (°C)</translation>
    </message>
    <message>
        <source>ΔT² (°C²)</source>
        <translation>ΔT² (°C²)</translation>
    </message>
    <message>
        <source>√ΔT (√°C)</source>
        <translation>√ΔT (√°C)</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE，%1 (dps)</translation>
    </message>
    <message>
        <source>Residual (dps)</source>
        <translation>残差 (dps)</translation>
    </message>
</context>
<context>
    <name>driftbench::TcqTimeView</name>
    <message>
        <source>Temperature quantities and drift error over time</source>
        <translation>温度量与漂移误差随时间变化</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>尚无测次</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>请采集一个测次，或打开日志文件。</translation>
    </message>
    <message>
        <source>Temperature quantity</source>
        <translation>温度量</translation>
    </message>
    <message>
        <source>TDE, mean and range</source>
        <translation>TDE，均值与范围</translation>
    </message>
    <message>
        <source>ΔT (°C)</source>
        <translation>ΔT (°C)</translation>
    </message>
    <message>
        <source>ΔT² (°C²)</source>
        <translation>ΔT² (°C²)</translation>
    </message>
    <message>
        <source>√ΔT (√°C)</source>
        <translation>√ΔT (√°C)</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE，%1 (dps)</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>起始后时间</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainFigures</name>
    <message>
        <source>Trained. Judged once all are.</source>
        <translation>已训练。全部完成后评判。</translation>
    </message>
    <message>
        <source>Waiting.</source>
        <translation>等待中。</translation>
    </message>
    <message>
        <source>Training on each set of runs.</source>
        <translation>正在对各组测次训练。</translation>
    </message>
    <message>
        <source>Cancelled before it was finished.</source>
        <translation>完成前已取消。</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainOptions</name>
    <message>
        <source>Preset of the RBF network</source>
        <translation>RBF 网络的预设</translation>
    </message>
    <message>
        <source>inputs of the RBF network</source>
        <translation>RBF 网络的输入</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>岭参数</translation>
    </message>
    <message>
        <source>Hidden units of the BP network</source>
        <translation>BP 网络的隐层单元</translation>
    </message>
    <message>
        <source>Starts of the BP network</source>
        <translation>BP 网络的起始次数</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>number of centres</source>
        <translation>中心数</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>岭参数</translation>
    </message>
    <message>
        <source>hidden units</source>
        <translation>隐层单元</translation>
    </message>
    <message>
        <source>starts</source>
        <translation>起始次数</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>hold-out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>评判方式</translation>
    </message>
    <message>
        <source>models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>One run in turn</source>
        <translation>逐次留出</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>仅 %1</translation>
    </message>
    <message>
        <source>Blocks of temperature</source>
        <translation>温度块</translation>
    </message>
    <message>
        <source>Auto, up to %1</source>
        <translation>自动，最多 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n, for every axis</source>
        <translation>
            <numerusform>%n，各轴相同</numerusform>
        </translation>
    </message>
    <message>
        <source>Auto, %1 tried</source>
        <translation>自动，试 %1 种</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>绝对</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>锚定</translation>
    </message>
    <message>
        <source>Gaussians on the temperature quantities, placed by orthogonal least squares.</source>
        <translation>温度量上的高斯函数，以正交最小二乘法确定位置。</translation>
    </message>
    <message>
        <source>A network with tanh units, trained from several seeded starts.</source>
        <translation>tanh 单元网络，由若干带种子的起始点训练。</translation>
    </message>
    <message>
        <source>As PX4 fits it: medians, 2 000 bins of temperature, a cubic.</source>
        <translation>按 PX4 的拟合方式：中位数，2 000 个温度分箱，三次多项式。</translation>
    </message>
    <message>
        <source>As ArduPilot fits it: means of 2 s, a cubic about 35 °C.</source>
        <translation>按 ArduPilot 的拟合方式：2 s 均值，以 35 °C 为中心的三次多项式。</translation>
    </message>
    <message>
        <source>Least squares on ΔT.</source>
        <translation>对 ΔT 的最小二乘。</translation>
    </message>
    <message>
        <source>Always in: the others can&apos;t tell every temperature from every other.</source>
        <translation>始终包含：其余各量无法区分所有温度。</translation>
    </message>
    <message>
        <source>The rate of the temperature is an experiment: it did not survive on recorded runs held out, and no table could hold it. driftbench-cli fit --dynamic measures it.</source>
        <translation>温度变化率为试验项：在留出的实测测次上未获证实，且补偿表无法容纳。可用 driftbench-cli fit --dynamic 测量。</translation>
    </message>
    <message>
        <source>Auto: the smallest number that does as well as the best on runs left out.</source>
        <translation>自动：在留出测次上与最优相当的最小数目。</translation>
    </message>
    <message>
        <source>Widths of the Gaussians, each half the one before, from the whole span down.</source>
        <translation>高斯函数的宽度，从全跨度起逐级减半。</translation>
    </message>
    <message>
        <source>How many samples&apos; worth of doubt shrinks each Gaussian. More is smoother.</source>
        <translation>以相当于多少个样本的不确定度收缩各高斯函数。越大越平滑。</translation>
    </message>
    <message>
        <source>Tanh units in the hidden layer of the BP network.</source>
        <translation>BP 网络隐层的 tanh 单元。</translation>
    </message>
    <message>
        <source>Seeded starts of the BP network; the best one counts.</source>
        <translation>BP 网络带种子的起始次数；取最优者。</translation>
    </message>
    <message>
        <source>Same runs, options and seed: the same models, bit for bit.</source>
        <translation>测次、选项和种子相同，则模型逐位相同。</translation>
    </message>
    <message>
        <source>Which runs are judged by models that have not seen them.</source>
        <translation>哪些测次由未见过它们的模型评判。</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts, as in PX4. Anchored: the bias at the start of each run is removed, as ArduPilot does.</source>
        <translation>绝对：计入启动零偏，同 PX4。锚定：去除各测次开始时的零偏，同 ArduPilot。</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>RBF inputs</source>
        <translation>RBF 输入</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最优</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>论文</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>RBF 网络</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>BP 网络</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as PX4</source>
        <translation>ΔT 的三次，同 PX4</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as ArduPilot</source>
        <translation>ΔT 的三次，同 ArduPilot</translation>
    </message>
    <message>
        <source>Line in ΔT</source>
        <translation>ΔT 的直线</translation>
    </message>
    <message>
        <source>Centres</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Widths</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>BP units</source>
        <translation>BP 单元</translation>
    </message>
    <message>
        <source>BP starts</source>
        <translation>BP 起始</translation>
    </message>
    <message>
        <source>Hold out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>评判</translation>
    </message>
    <message>
        <source>Number of centres</source>
        <translation>中心数</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainPage</name>
    <message>
        <source>Models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Progress of the training</source>
        <translation>训练进度</translation>
    </message>
    <message>
        <source>The training was refused.</source>
        <translation>训练被拒绝。</translation>
    </message>
    <message>
        <source>The training can&apos;t start.</source>
        <translation>无法开始训练。</translation>
    </message>
    <message numerus="yes">
        <source>take %n centres</source>
        <translation>
            <numerusform>取 %n 个中心</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Each run is held out once.</source>
        <translation>各测次逐次留出。</translation>
    </message>
    <message>
        <source>Shown is what was trained before the last change. Train again.</source>
        <translation>所示为上次更改前的训练结果。请重新训练。</translation>
    </message>
    <message>
        <source>Blocks of temperature are held out: one run can&apos;t show that another repeats it.</source>
        <translation>留出的是温度块：单个测次无法证明另一测次会重复。</translation>
    </message>
    <message>
        <source>Each run is held out once. Held-out error counts, training error does not.</source>
        <translation>各测次逐次留出。以留出误差为准，训练误差不计。</translation>
    </message>
    <message>
        <source>Train again</source>
        <translation>重新训练</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>训练</translation>
    </message>
    <message>
        <source>Nothing to train on</source>
        <translation>无可训练的数据</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>请采集一个测次，或打开日志文件。</translation>
    </message>
    <message>
        <source>Not trained yet</source>
        <translation>尚未训练</translation>
    </message>
    <message>
        <source>Choose the models at the left and train them.</source>
        <translation>请在左侧选择模型并训练。</translation>
    </message>
    <message>
        <source>These runs can&apos;t be trained on.</source>
        <translation>这些测次无法用于训练。</translation>
    </message>
    <message>
        <source>Centres: the fewest that do as well as the best on runs left out. Here %1.</source>
        <translation>中心：在留出测次上与最优相当的最小数目。此处为 %1。</translation>
    </message>
    <message>
        <source>Training, %1 %</source>
        <translation>训练中，%1 %</translation>
    </message>
    <message>
        <source>Changed, train again</source>
        <translation>已更改，请重新训练</translation>
    </message>
    <message numerus="yes">
        <source>%n model(s)</source>
        <translation>
            <numerusform>%n 个模型</numerusform>
        </translation>
    </message>
    <message>
        <source>Esc cancel. What is finished is kept.</source>
        <translation>Esc 取消。已完成的部分保留。</translation>
    </message>
    <message>
        <source>Ctrl+R train · Click the curve of the excess to take that number of centres · F fit</source>
        <translation>Ctrl+R 训练 · 单击超出量曲线 采用该中心数 · F 适应窗口</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s), %1 samples</source>
        <translation>
            <numerusform>%n 个测次，%1 个样本</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Look at the runs</source>
        <translation>查看测次</translation>
    </message>
    <message>
        <source>Train the chosen models and judge them on runs held out</source>
        <translation>训练所选模型，并用留出测次评判</translation>
    </message>
</context>
<context>
    <name>driftbench::TransientView</name>
    <message>
        <source>What is left of a step at the centre of the chamber, over time</source>
        <translation>温箱中心处温度阶跃的剩余量随时间变化</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 to ±%2 °C</source>
        <translation>%1 后达 ±%2 °C</translation>
    </message>
    <message>
        <source>Nothing to settle</source>
        <translation>无需稳定</translation>
    </message>
    <message>
        <source>The step is within what the thermometer can tell.</source>
        <translation>步长在温度计可分辨的范围之内。</translation>
    </message>
    <message>
        <source>Time after a step of %1 °C</source>
        <translation>%1 °C 阶跃后的时间</translation>
    </message>
    <message>
        <source>Still to go (°C)</source>
        <translation>剩余温差 (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::UploadSteps</name>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>回读</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>校验</translation>
    </message>
    <message>
        <source>Commit</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>激活</translation>
    </message>
    <message>
        <source>No upload under way</source>
        <translation>无上传进行中</translation>
    </message>
    <message>
        <source>Upload done</source>
        <translation>上传完成</translation>
    </message>
    <message>
        <source>Upload, step %1 of 6: %2</source>
        <translation>上传，第 %1/6 步：%2</translation>
    </message>
</context>
<context>
    <name>driftbench::VerdictCard</name>
    <message>
        <source>Write the table.</source>
        <translation>写补偿表。</translation>
    </message>
    <message>
        <source>Write only a constant, or the table with care.</source>
        <translation>仅写常数，或慎用补偿表。</translation>
    </message>
    <message>
        <source>Write the table with care.</source>
        <translation>写补偿表，但须慎用。</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>%1 轴不写补偿表。</translation>
    </message>
    <message>
        <source>Nothing to write for %1: its bias does not move with temperature.</source>
        <translation>%1 轴无需写入：其零偏不随温度变化。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1 times less than a constant</source>
        <translation>为常数的 1/%1</translation>
    </message>
    <message>
        <source>%1 to %2 times less than a constant</source>
        <translation>为常数的 1/%1 至 1/%2</translation>
    </message>
    <message>
        <source>It was not judged on any run.</source>
        <translation>未在任何测次上评判。</translation>
    </message>
    <message>
        <source>It leaves %1 dps rms</source>
        <translation>残余 %1 dps rms</translation>
    </message>
    <message>
        <source>With the %1 it leaves %2 dps rms</source>
        <translation>用 %1，残余 %2 dps rms</translation>
    </message>
    <message>
        <source>, over the limit of %1</source>
        <translation>，超出限值 %1</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>，%1</translation>
    </message>
    <message>
        <source>, a constant %1</source>
        <translation>，常数为 %1</translation>
    </message>
    <message>
        <source>A constant does better on %1.</source>
        <translation>在 %1 上常数更优。</translation>
    </message>
    <message>
        <source>The rest is hysteresis, %1 times the noise.</source>
        <translation>其余为迟滞，为噪声的 %1 倍。</translation>
    </message>
    <message>
        <source>Verdict for %1: %2. %3</source>
        <translation>%1 轴的判定：%2。%3</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>With care</source>
        <translation>慎用</translation>
    </message>
    <message>
        <source>No</source>
        <translation>否</translation>
    </message>
    <message>
        <source>No drift</source>
        <translation>无漂移</translation>
    </message>
    <message numerus="yes">
        <source>fails on %1 of %n runs</source>
        <translation>
            <numerusform>%n 个测次中 %1 个不合格</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>passes on %1 of %n runs</source>
        <translation>
            <numerusform>%n 个测次中 %1 个合格</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::Workbench</name>
    <message>
        <source>Simulated bridge</source>
        <translation>仿真桥接器</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>陀螺桥接器</translation>
    </message>
</context>
</TS>
