<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>SimulatedTour</name>
    <message>
        <source>Choose where the samples come from.</source>
        <translation>サンプルの取得元を選択します。</translation>
    </message>
    <message>
        <source>The simulated bridge runs the firmware of a real one over a simulated gyro in a chamber. Next uses it.</source>
        <translation>模擬ブリッジは、恒温槽内の模擬ジャイロに対して実物のファームウェアを動かします。「次へ」で使用します。</translation>
    </message>
    <message>
        <source>Plan how the temperature moves.</source>
        <translation>温度の動かし方を計画します。</translation>
    </message>
    <message>
        <source>From −40 to 85 °C in steps that the datasheets allow. The tour takes three runs instead of five; each is judged by a model of the others.</source>
        <translation>データシートが許すステップで −40～85 °C。ツアーの測定は 5 回ではなく 3 回で、それぞれ他の測定のモデルで判定されます。</translation>
    </message>
    <message>
        <source>Record the runs.</source>
        <translation>測定を記録します。</translation>
    </message>
    <message>
        <source>Three hours pass in about twelve seconds. Everything is in the session&apos;s file as it comes.</source>
        <translation>3 時間が約 12 秒で過ぎます。データは届き次第すべてセッションファイルに入ります。</translation>
    </message>
    <message>
        <source>Recording run %1 of %2.</source>
        <translation>測定 %1/%2 を記録中です。</translation>
    </message>
    <message>
        <source>Look at the drift.</source>
        <translation>ドリフトを見ます。</translation>
    </message>
    <message>
        <source>Train the models.</source>
        <translation>モデルを学習します。</translation>
    </message>
    <message>
        <source>An RBF network and its rivals. Each run is held out once, so that no model is judged on what it has seen.</source>
        <translation>RBF ネットワークと競合モデルです。各測定を 1 回ずつ検証に使うため、学習済みのデータで判定されるモデルはありません。</translation>
    </message>
    <message>
        <source>Read the verdict.</source>
        <translation>判定を読みます。</translation>
    </message>
    <message>
        <source>For each axis: write the table, only a constant, or nothing, with the reason.</source>
        <translation>軸ごとに、テーブルを書き込む、定数のみ、何も書き込まない、のいずれかを理由とともに示します。</translation>
    </message>
    <message>
        <source>Write the table into the device.</source>
        <translation>テーブルをデバイスに書き込みます。</translation>
    </message>
    <message>
        <source>Written to the spare bank, read back, verified, and only then made active. Cut off anywhere, the old table stays.</source>
        <translation>予備バンクに書き込み、読み戻し、照合した後に初めて有効化します。どこで中断しても、旧テーブルが残ります。</translation>
    </message>
    <message>
        <source>That did not work; the page says why. Try again, or skip it.</source>
        <translation>うまくいきませんでした。理由はページにあります。再試行するか、スキップしてください。</translation>
    </message>
    <message>
        <source>No bridge is chosen; choose the simulated one on the Source page.</source>
        <translation>ブリッジが選択されていません。ソースのページで模擬ブリッジを選択してください。</translation>
    </message>
    <message>
        <source>The training ended without a model. Try again, or skip it.</source>
        <translation>モデルなしで学習が終わりました。再試行するか、スキップしてください。</translation>
    </message>
    <message>
        <source>There is no model to write; go back to Train, or end the tour.</source>
        <translation>書き込むモデルがありません。学習に戻るか、ツアーを終了してください。</translation>
    </message>
    <message>
        <source>The device computed something else with the new table and has its old one again. Try again, or skip it.</source>
        <translation>新しいテーブルでのデバイスの計算結果が異なるため、元のテーブルに戻しました。再試行するか、スキップしてください。</translation>
    </message>
    <message>
        <source>The bridge was unplugged. Plug it in and try again, or stop the run and end the tour.</source>
        <translation>ブリッジが取り外されました。接続して再試行するか、測定を停止してツアーを終了してください。</translation>
    </message>
    <message>
        <source>Each sample&apos;s error against temperature. Where they lie on one curve, a table can remove it.</source>
        <translation>各サンプルの誤差と温度の関係です。一本の曲線上にあれば、テーブルで取り除けます。</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Source</source>
        <translation>ソース</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>計画</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>学習</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>エクスポート</translation>
    </message>
    <message>
        <source>Choose one</source>
        <translation>ソースを選択</translation>
    </message>
    <message>
        <source>Temperature steps</source>
        <translation>温度ステップ</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>ライブ波形</translation>
    </message>
    <message>
        <source>Look at the drift</source>
        <translation>ドリフトを見る</translation>
    </message>
    <message>
        <source>Fit models</source>
        <translation>モデルの当てはめ</translation>
    </message>
    <message>
        <source>Judge the fit</source>
        <translation>当てはめの判定</translation>
    </message>
    <message>
        <source>Write the table</source>
        <translation>テーブルの書き込み</translation>
    </message>
</context>
<context>
    <name>driftbench::AllanView</name>
    <message>
        <source>Allan deviation before and after compensation</source>
        <translation>補償前後のアラン偏差</translation>
    </message>
    <message>
        <source>No Allan deviation</source>
        <translation>アラン偏差なし</translation>
    </message>
    <message>
        <source>It needs a stretch of nine samples or more without a gap.</source>
        <translation>途切れのない 9 サンプル以上の区間が必要です。</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>補償前</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>補償後、%1</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>平均時間 τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>最小 補償前 %1、補償後 %2 dps</translation>
    </message>
</context>
<context>
    <name>driftbench::Banner</name>
    <message>
        <source>Line to copy</source>
        <translation>コピーする行</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
</context>
<context>
    <name>driftbench::BeforeAfterView</name>
    <message>
        <source>Rates before and after compensation</source>
        <translation>補償前後の角速度</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>%1 角速度 (dps)</translation>
    </message>
    <message>
        <source>%1 dps rms raw</source>
        <translation>生値 %1 dps rms</translation>
    </message>
    <message>
        <source>%1 dps rms comp.</source>
        <translation>補償後 %1 dps rms</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Nothing to compare yet</source>
        <translation>比較対象なし</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>モデルを学習し、学習に使っていない測定を選択してください。</translation>
    </message>
    <message>
        <source>Raw, mean and range</source>
        <translation>生値、平均と範囲</translation>
    </message>
    <message>
        <source>Compensated, %1</source>
        <translation>補償後、%1</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>経過時間</translation>
    </message>
</context>
<context>
    <name>driftbench::BridgeModel</name>
    <message>
        <source>Simulated bridge</source>
        <translation>模擬ブリッジ</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>ジャイロブリッジ</translation>
    </message>
    <message>
        <source>%1, USB to I2C</source>
        <translation>%1、USB–I2C</translation>
    </message>
    <message>
        <source>inside this program</source>
        <translation>プログラム内蔵</translation>
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
        <translation>受信中</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>In use here</source>
        <translation>ここで使用中</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>Not permitted</source>
        <translation>権限なし</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>取り外し</translation>
    </message>
    <message>
        <source>No gyro answers</source>
        <translation>ジャイロ応答なし</translation>
    </message>
    <message>
        <source>Bus stuck</source>
        <translation>バス固着</translation>
    </message>
    <message>
        <source>Other version</source>
        <translation>バージョン不一致</translation>
    </message>
    <message>
        <source>Unknown gyro</source>
        <translation>不明なジャイロ</translation>
    </message>
    <message>
        <source>Not usable</source>
        <translation>使用不可</translation>
    </message>
    <message>
        <source>start here if you have no hardware</source>
        <translation>ハードウェアがない場合はここから</translation>
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
        <translation>RBF 学習</translation>
    </message>
    <message>
        <source>RBF held out</source>
        <translation>RBF 検証</translation>
    </message>
    <message>
        <source>%1 chosen</source>
        <translation>選択 %1</translation>
    </message>
    <message>
        <source>RBF, temperature blocks left out</source>
        <translation>RBF、温度ブロックで検証</translation>
    </message>
    <message>
        <source>RBF held out, mean of %1</source>
        <translation>RBF 検証、%1 件の平均</translation>
    </message>
    <message>
        <source>RBF held out, mean</source>
        <translation>RBF 検証、平均</translation>
    </message>
    <message>
        <source>Excess over the noise floor</source>
        <translation>ノイズフロアからの超過分</translation>
    </message>
    <message>
        <source>lowest to highest run</source>
        <translation>測定の最小～最大</translation>
    </message>
    <message>
        <source>lowest to highest block</source>
        <translation>ブロックの最小～最大</translation>
    </message>
    <message>
        <source>Chosen number</source>
        <translation>選択した中心数</translation>
    </message>
    <message>
        <source>Excess MSD (%)</source>
        <translation>MSD 超過分 (%)</translation>
    </message>
    <message>
        <source>Excess over the noise floor against the number of centres</source>
        <translation>中心数に対するノイズフロアからの超過分</translation>
    </message>
    <message>
        <source>The curve, its centres and their widths</source>
        <translation>曲線とその中心および幅</translation>
    </message>
    <message>
        <source>Centres of the RBF network</source>
        <translation>RBF ネットワークの中心</translation>
    </message>
    <message>
        <source>The curve, less its straight line</source>
        <translation>直線を差し引いた曲線</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>RBF ネットワーク</translation>
    </message>
    <message>
        <source>Means of 1 °C</source>
        <translation>1 °C ごとの平均</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Width, ±1 σ</source>
        <translation>幅、±1 σ</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>TDE less line (dps)</source>
        <translation>直線差引き TDE (dps)</translation>
    </message>
    <message>
        <source>No RBF network yet</source>
        <translation>RBF ネットワークなし</translation>
    </message>
    <message>
        <source>Train one to see how many centres it needs.</source>
        <translation>学習すると、必要な中心数が分かります。</translation>
    </message>
    <message>
        <source>No choice was made</source>
        <translation>選択は行われていません</translation>
    </message>
    <message>
        <source>The number of centres was given, so none was tried.</source>
        <translation>中心数が指定されたため、試行していません。</translation>
    </message>
</context>
<context>
    <name>driftbench::CoachStrip</name>
    <message>
        <source>Guided tour</source>
        <translation>ガイドツアー</translation>
    </message>
    <message>
        <source>Guided tour, %1 of %2</source>
        <translation>ガイドツアー、%1/%2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>スキップ</translation>
    </message>
    <message>
        <source>End tour</source>
        <translation>ツアーを終了</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>再試行</translation>
    </message>
</context>
<context>
    <name>driftbench::ComparePage</name>
    <message>
        <source>Held-out run</source>
        <translation>検証用の測定</translation>
    </message>
    <message>
        <source>Comparison of the models on the held-out run</source>
        <translation>検証用の測定でのモデル比較</translation>
    </message>
    <message>
        <source>Limit of what may be left, rms</source>
        <translation>残留の許容値、rms</translation>
    </message>
    <message>
        <source>dps</source>
        <translation>dps</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Judging</source>
        <translation>判定方法</translation>
    </message>
    <message>
        <source>Progress of the report</source>
        <translation>レポートの進捗</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>判定方法</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>レポートの作成</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML, one file (*.html)</source>
        <translation>HTML、1 ファイル (*.html)</translation>
    </message>
    <message>
        <source>There is nothing to report yet.</source>
        <translation>レポートの対象がまだありません。</translation>
    </message>
    <message>
        <source>Train a model first; its runs must be readable.</source>
        <translation>先にモデルを学習してください。測定が読み取れる必要があります。</translation>
    </message>
    <message>
        <source>Report written to %1.</source>
        <translation>レポートを %1 に保存しました。</translation>
    </message>
    <message>
        <source>The report is written.</source>
        <translation>レポートを作成しました。</translation>
    </message>
    <message>
        <source>The report was not written.</source>
        <translation>レポートを作成できませんでした。</translation>
    </message>
    <message>
        <source>Models against a constant, on runs they have not seen</source>
        <translation>学習に使っていない測定での、モデルと定数の比較</translation>
    </message>
    <message>
        <source>%1 against a constant, on runs it has not seen</source>
        <translation>学習に使っていない測定での、%1 と定数の比較</translation>
    </message>
    <message>
        <source>The models are trained and judged on runs held out.</source>
        <translation>モデルを学習し、検証用の測定で判定しています。</translation>
    </message>
    <message>
        <source>Nothing to judge</source>
        <translation>判定対象なし</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>先にモデルを学習してください。</translation>
    </message>
    <message>
        <source>%1 of 3 axes: yes</source>
        <translation>3 軸中 %1 軸が可</translation>
    </message>
    <message>
        <source>1, 2, 3 choose the held-out run · Wheel zoom · Drag pan · Double-click fit · Ctrl+E export what is visible</source>
        <translation>1, 2, 3 検証用の測定を選択 · ホイール ズーム · ドラッグ 移動 · ダブルクリック 全体表示 · Ctrl+E 表示範囲をエクスポート</translation>
    </message>
    <message numerus="yes">
        <source>%n held-out run(s)</source>
        <translation>
            <numerusform>検証用の測定 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Judged: anchored</source>
        <translation>判定：始点基準</translation>
    </message>
    <message>
        <source>Judged: absolute</source>
        <translation>判定：絶対</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>What may be left on a held-out run, rms. Zero: no limit.</source>
        <translation>検証用の測定での残留の許容値、rms。0 は許容値なしです。</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>絶対</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>始点基準</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>レポート…</translation>
    </message>
    <message>
        <source>Everything found as PDF or as one HTML file</source>
        <translation>すべての結果を PDF または 1 つの HTML ファイルに出力</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>学習</translation>
    </message>
    <message>
        <source>Held-out run %1</source>
        <translation>検証用の測定 %1</translation>
    </message>
    <message>
        <source>The report was cancelled.</source>
        <translation>レポートをキャンセルしました。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
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
        <translation>測定</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>MSD1
before</source>
        <translation>MSD1
補償前</translation>
    </message>
    <message>
        <source>MSD4
Conv. 1</source>
        <translation>MSD4
従来法 1</translation>
    </message>
    <message>
        <source>MSD5
Conv. 2</source>
        <translation>MSD5
従来法 2</translation>
    </message>
    <message>
        <source>MSD6
Novel</source>
        <translation>MSD6
提案法</translation>
    </message>
    <message>
        <source>Q3
Conv. 1</source>
        <translation>Q3
従来法 1</translation>
    </message>
    <message>
        <source>Q4
Conv. 2</source>
        <translation>Q4
従来法 2</translation>
    </message>
    <message>
        <source>Q5
Novel</source>
        <translation>Q5
提案法</translation>
    </message>
    <message>
        <source>Q4 − Q3
% of Q3</source>
        <translation>Q4 − Q3
Q3 比 %</translation>
    </message>
    <message>
        <source>Q5 − Q3
% of Q3</source>
        <translation>Q5 − Q3
Q3 比 %</translation>
    </message>
    <message>
        <source>Q5 − Q4
% of Q4</source>
        <translation>Q5 − Q4
Q4 比 %</translation>
    </message>
    <message>
        <source>MSD
cubic</source>
        <translation>MSD
3 次式</translation>
    </message>
    <message>
        <source>MSD
constant</source>
        <translation>MSD
定数</translation>
    </message>
    <message>
        <source>MSD
floor</source>
        <translation>MSD
フロア</translation>
    </message>
    <message>
        <source>Left
dps rms</source>
        <translation>残留
dps rms</translation>
    </message>
    <message>
        <source>Limit
%1</source>
        <translation>許容値
%1</translation>
    </message>
    <message>
        <source>Limit
none</source>
        <translation>許容値
なし</translation>
    </message>
</context>
<context>
    <name>driftbench::CoverageView</name>
    <message>
        <source>Coverage of the temperature range</source>
        <translation>温度範囲のカバレッジ</translation>
    </message>
    <message>
        <source>No coverage yet</source>
        <translation>カバレッジなし</translation>
    </message>
    <message>
        <source>It shows where the temperature has been.</source>
        <translation>温度がどの範囲を通ったかを示します。</translation>
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
        <translation>昇温</translation>
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
        <translation>曲線なし</translation>
    </message>
    <message>
        <source>There is nothing to draw over this range.</source>
        <translation>この範囲には描画するものがありません。</translation>
    </message>
</context>
<context>
    <name>driftbench::DataTable</name>
    <message>
        <source>Copy selected cells</source>
        <translation>選択したセルをコピー</translation>
    </message>
    <message>
        <source>Copy table as text</source>
        <translation>表をテキストでコピー</translation>
    </message>
    <message>
        <source>Copy table as CSV</source>
        <translation>表を CSV でコピー</translation>
    </message>
    <message>
        <source>Copy table as Markdown</source>
        <translation>表を Markdown でコピー</translation>
    </message>
    <message>
        <source>Copy table as LaTeX</source>
        <translation>表を LaTeX でコピー</translation>
    </message>
</context>
<context>
    <name>driftbench::DevicePanel</name>
    <message>
        <source>On the device now against what would be written</source>
        <translation>デバイスの現在の内容と書き込み予定の内容</translation>
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
        <translation>有効化と確認</translation>
    </message>
    <message>
        <source>Writing the spare bank</source>
        <translation>予備バンクに書き込み中</translation>
    </message>
    <message>
        <source>The table in use stays active until the last step.</source>
        <translation>使用中のテーブルは最後のステップまで有効です。</translation>
    </message>
    <message>
        <source>Write to the device</source>
        <translation>デバイスへの書き込み</translation>
    </message>
    <message>
        <source>Read back and verified. This device can&apos;t show its compensation at work.</source>
        <translation>読み戻して照合しました。このデバイスでは補償動作を確認できません。</translation>
    </message>
    <message>
        <source>Rolled back: %1 of %2 samples differ from what the host computes, by up to %3 dps.</source>
        <translation>ロールバックしました：%2 サンプル中 %1 サンプルがホストの計算値と最大 %3 dps 異なります。</translation>
    </message>
    <message numerus="yes">
        <source>Verified at work: %n sample(s) compared with what the host computes, none differs.</source>
        <translation>
            <numerusform>動作を照合しました：%n サンプルをホストの計算値と比較し、すべて一致しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>キャンセル済み</translation>
    </message>
    <message>
        <source>Not written</source>
        <translation>未書き込み</translation>
    </message>
    <message>
        <source>The upload was cancelled.</source>
        <translation>アップロードをキャンセルしました。</translation>
    </message>
    <message>
        <source>The table was not written.</source>
        <translation>テーブルを書き込めませんでした。</translation>
    </message>
    <message>
        <source>gen. %1</source>
        <translation>世代 %1</translation>
    </message>
    <message>
        <source>bank %1</source>
        <translation>バンク %1</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>ロールバック済み</translation>
    </message>
    <message>
        <source>Bank %1 is in use</source>
        <translation>バンク %1 を使用中</translation>
    </message>
    <message>
        <source>The new table was rolled back.</source>
        <translation>新しいテーブルをロールバックしました。</translation>
    </message>
    <message>
        <source>The table is on the device.</source>
        <translation>テーブルをデバイスに書き込みました。</translation>
    </message>
    <message>
        <source>The table before was not restored.</source>
        <translation>以前のテーブルを復元できませんでした。</translation>
    </message>
    <message>
        <source>Bank %1, generation %2, is in use again.</source>
        <translation>バンク %1、世代 %2 を再び使用しています。</translation>
    </message>
    <message>
        <source>No table is in use any more; the device sends raw rates.</source>
        <translation>使用中のテーブルはなくなり、デバイスは生の角速度を送ります。</translation>
    </message>
    <message>
        <source>The table was taken out of use.</source>
        <translation>テーブルの使用を停止しました。</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>ここでは不明</translation>
    </message>
    <message>
        <source>fixed point</source>
        <translation>固定小数点</translation>
    </message>
    <message>
        <source>float32</source>
        <translation>float32</translation>
    </message>
    <message>
        <source>on the die</source>
        <translation>ダイ上</translation>
    </message>
    <message>
        <source>external</source>
        <translation>外付け</translation>
    </message>
    <message>
        <source>Bank, generation</source>
        <translation>バンク、世代</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Range, rows</source>
        <translation>範囲、行数</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>センサ</translation>
    </message>
    <message>
        <source>CRC-32</source>
        <translation>CRC-32</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, active</source>
        <translation>%1, %2, 有効</translation>
    </message>
    <message>
        <source>no image: see Files</source>
        <translation>イメージなし：ファイル参照</translation>
    </message>
    <message>
        <source>On the device now</source>
        <translation>デバイスの現在値</translation>
    </message>
    <message>
        <source>Would be written</source>
        <translation>書き込み予定</translation>
    </message>
    <message>
        <source>Device %1</source>
        <translation>デバイス %1</translation>
    </message>
    <message>
        <source>%1, firmware %2, simulated</source>
        <translation>%1、ファームウェア %2、模擬</translation>
    </message>
    <message>
        <source>%1, firmware %2</source>
        <translation>%1、ファームウェア %2</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>No device chosen</source>
        <translation>デバイス未選択</translation>
    </message>
    <message>
        <source>Choose the simulated bridge or a plugged-in one as source.</source>
        <translation>ソースとして模擬ブリッジか接続済みのブリッジを選択してください。</translation>
    </message>
    <message>
        <source>No tables there</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>Looking at the device</source>
        <translation>デバイスを調べています</translation>
    </message>
    <message>
        <source>Bank %1 active</source>
        <translation>バンク %1 が有効</translation>
    </message>
    <message>
        <source>No table active</source>
        <translation>有効なテーブルなし</translation>
    </message>
    <message>
        <source>%1, the spare bank being written</source>
        <translation>%1、予備バンクに書き込み中</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Activation not confirmed</source>
        <translation>有効化は未確認</translation>
    </message>
    <message>
        <source>Look at the device to see which table is in use.</source>
        <translation>使用中のテーブルはデバイスを確認してください。</translation>
    </message>
    <message>
        <source>The table that was in use still is.</source>
        <translation>使用中だったテーブルは引き続き有効です。</translation>
    </message>
    <message>
        <source>The activation was not confirmed.</source>
        <translation>有効化を確認できませんでした。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>推奨</translation>
    </message>
    <message>
        <source>%1 to %2 °C, %3</source>
        <translation>%1～%2 °C、%3</translation>
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
        <translation>時刻</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>内容</translation>
    </message>
</context>
<context>
    <name>driftbench::ExcludedModel</name>
    <message>
        <source>non-finite</source>
        <translation>非有限値</translation>
    </message>
    <message>
        <source>bad time</source>
        <translation>時刻異常</translation>
    </message>
    <message>
        <source>start-up</source>
        <translation>起動直後</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>飽和</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>動き検出</translation>
    </message>
    <message>
        <source>temperature fault</source>
        <translation>温度異常</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>外れ値</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Time (%1)</source>
        <translation>時間 (%1)</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>理由</translation>
    </message>
</context>
<context>
    <name>driftbench::ExclusionStrip</name>
    <message>
        <source>excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Drift error over time</source>
        <translation>ドリフト誤差の時系列</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>サンプルなし</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>測定を記録するか、ログファイルを開いてください。</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>昇温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>選択中</translation>
    </message>
</context>
<context>
    <name>driftbench::ExportPage</name>
    <message>
        <source>Table preview</source>
        <translation>テーブルのプレビュー</translation>
    </message>
    <message>
        <source>Recommended of each axis</source>
        <translation>各軸の推奨モデル</translation>
    </message>
    <message>
        <source>There is no table to write.</source>
        <translation>書き込むテーブルがありません。</translation>
    </message>
    <message>
        <source>The table for the device</source>
        <translation>デバイス用のテーブル</translation>
    </message>
    <message>
        <source>Into the spare bank; the one in use stays until the end</source>
        <translation>予備バンクに書き込み、使用中のものは最後まで残ります</translation>
    </message>
    <message>
        <source>There is no table to write</source>
        <translation>書き込むテーブルがありません</translation>
    </message>
    <message>
        <source>A table is being written</source>
        <translation>テーブルを書き込み中です</translation>
    </message>
    <message>
        <source>No device with tables is there</source>
        <translation>テーブル対応のデバイスがありません</translation>
    </message>
    <message>
        <source>Folder for the files</source>
        <translation>ファイルの保存先フォルダ</translation>
    </message>
    <message>
        <source>The files were not written.</source>
        <translation>ファイルを保存できませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1.</source>
        <translation>
            <numerusform>%n 個のファイルを %1 に保存しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written.</source>
        <translation>
            <numerusform>%n 個のファイルを保存しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing, %1 %</source>
        <translation>書き込み中、%1 %</translation>
    </message>
    <message>
        <source>Table on %1</source>
        <translation>%1 書込済</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written</source>
        <translation>
            <numerusform>ファイル %n 個を保存済み</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing written</source>
        <translation>書き込みなし</translation>
    </message>
    <message>
        <source>Esc cancel, the old table stays · Ctrl+S save the files</source>
        <translation>Esc キャンセル（旧テーブルを維持） · Ctrl+S ファイルを保存</translation>
    </message>
    <message>
        <source>Ctrl+S save the files · Ctrl+U write to the device · F5 look again · Ctrl+C copy the selected cells</source>
        <translation>Ctrl+S ファイルを保存 · Ctrl+U デバイスに書き込み · F5 再検索 · Ctrl+C 選択したセルをコピー</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>ファイルを保存…</translation>
    </message>
    <message>
        <source>Write to device</source>
        <translation>デバイスに書き込み</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Takes the table out of use; the one before it takes over</source>
        <translation>テーブルの使用を停止し、前のテーブルに戻します</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>ソースを選択</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>学習</translation>
    </message>
    <message>
        <source>No model yet</source>
        <translation>モデルなし</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>先にモデルを学習してください。</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Shown form</source>
        <translation>表示形式</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>ファイルのプレビュー</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>テーブル</translation>
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
        <translation>C ヘッダ</translation>
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
        <translation>デバイスイメージ</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>再検索</translation>
    </message>
    <message>
        <source>int32, 1 LSB = 2%1 dps = %2 µdps</source>
        <translation>int32、1 LSB = 2%1 dps = %2 µdps</translation>
    </message>
    <message>
        <source>Table of %1 rows, %2 °C apart.</source>
        <translation>%1 行、%2 °C 間隔</translation>
    </message>
    <message>
        <source>Axes without a yes are written too.</source>
        <translation>「可」でない軸も書き込まれます。</translation>
    </message>
    <message>
        <source>Compare says what that costs on runs held out.</source>
        <translation>検証用の測定での影響は「比較」に示されます。</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>%1 のテーブルはありません。</translation>
    </message>
    <message>
        <source>It does not help on runs held out; Compare has the figures. Its values are zero.</source>
        <translation>検証用の測定で効果がありません。数値は「比較」にあります。値は 0 になります。</translation>
    </message>
</context>
<context>
    <name>driftbench::FileChoices</name>
    <message>
        <source>Largest interpolation error</source>
        <translation>補間誤差の最大値</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>cubic, loses nothing</source>
        <translation>3 次式、損失なし</translation>
    </message>
    <message>
        <source>cubic only: up to %1 mdps off on %2, %3 rms</source>
        <translation>3 次式のみ：%2 で最大 %1 mdps、%3 rms のずれ</translation>
    </message>
    <message>
        <source>%1 of %2 chosen</source>
        <translation>%2 件中 %1 件を選択</translation>
    </message>
    <message numerus="yes">
        <source>table, %n row(s)</source>
        <translation>
            <numerusform>テーブル、%n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>table in both kinds and where it comes from, exact</source>
        <translation>両形式のテーブルと由来、厳密値</translation>
    </message>
    <message>
        <source>float and fixed point, %1 bytes</source>
        <translation>浮動小数点と固定小数点、%1 バイト</translation>
    </message>
    <message>
        <source>one bank, %1 bytes</source>
        <translation>1 バンク、%1 バイト</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
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
        <translation>C ヘッダ</translation>
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
        <translation>デバイスイメージ</translation>
    </message>
    <message>
        <source>Also axes without a yes</source>
        <translation>「可」でない軸も含める</translation>
    </message>
    <message>
        <source>Axes whose verdict is not yes are left out unless this is on; the files say so.</source>
        <translation>判定が「可」でない軸は、これがオンでない限り省かれます。ファイルにもその旨が記されます。</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>最大誤差</translation>
    </message>
    <message>
        <source>PX4 device id</source>
        <translation>PX4 デバイス ID</translation>
    </message>
    <message>
        <source>By which PX4 knows the gyro again: its parameter TC_G0_ID. Empty: the serial number.</source>
        <translation>PX4 がジャイロを識別するためのパラメータ TC_G0_ID です。空欄の場合はシリアル番号を使います。</translation>
    </message>
    <message>
        <source>needs the gyro&apos;s device id, below</source>
        <translation>下のジャイロのデバイス ID が必要</translation>
    </message>
    <message>
        <source>needs the sensor&apos;s name: state it when you open the log</source>
        <translation>センサの情報が必要（ログを開くときに入力）</translation>
    </message>
</context>
<context>
    <name>driftbench::FileSurvey</name>
    <message>
        <source>Span too small to fit</source>
        <translation>スパン不足で当てはめ不可</translation>
    </message>
    <message>
        <source>Temperature stands still</source>
        <translation>温度変化なし</translation>
    </message>
    <message>
        <source>Too short to fit</source>
        <translation>短すぎて当てはめ不可</translation>
    </message>
    <message>
        <source>Can&apos;t be used as it is</source>
        <translation>このままでは使用不可</translation>
    </message>
    <message>
        <source>No drift found</source>
        <translation>ドリフト検出なし</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1：ヒステリシス</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>Can&apos;t be opened</source>
        <translation>開けません</translation>
    </message>
    <message>
        <source>Run %1 to do</source>
        <translation>測定 %1 が未実施</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>Ready to train</source>
        <translation>学習可能</translation>
    </message>
    <message>
        <source>Not there any more</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>不明な形式</translation>
    </message>
    <message>
        <source>Large: looked at when opened</source>
        <translation>大容量：開く際に調査</translation>
    </message>
    <message>
        <source>Can&apos;t be read</source>
        <translation>読み取り不可</translation>
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
        <translation>応答したもの</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>ジャイロ</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>レンジ</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>サンプルレート</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>温度計</translation>
    </message>
    <message>
        <source>Die offset</source>
        <translation>ダイのオフセット</translation>
    </message>
    <message>
        <source>Bus speed</source>
        <translation>バス速度</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>外付け、なければダイ</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>ダイ上</translation>
    </message>
    <message>
        <source>0 takes the gyro&apos;s usual rate.</source>
        <translation>0 でジャイロの標準レートになります。</translation>
    </message>
    <message>
        <source>Of the gyro&apos;s own thermometer, which only tells differences.</source>
        <translation>ジャイロ内蔵の温度計のもので、温度差しか分かりません。</translation>
    </message>
    <message>
        <source>which gyro it is</source>
        <translation>どのジャイロか</translation>
    </message>
    <message>
        <source>The gyro can&apos;t say it itself; it keeps runs of different gyros apart.</source>
        <translation>ジャイロ自身では識別できません。異なるジャイロの測定を区別します。</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectPage</name>
    <message>
        <source>What is plotted</source>
        <translation>プロットの内容</translation>
    </message>
    <message>
        <source>name the reason</source>
        <translation>理由の記入</translation>
    </message>
    <message>
        <source>Against TCQ</source>
        <translation>対 TCQ</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>時系列</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>指摘事項</translation>
    </message>
    <message>
        <source>exclude %1 s of %2</source>
        <translation>%2 の %1 s を除外</translation>
    </message>
    <message>
        <source>include a stretch of %1</source>
        <translation>%1 の区間を除外から復帰</translation>
    </message>
    <message>
        <source>move an excluded stretch of %1</source>
        <translation>%1 の除外区間を移動</translation>
    </message>
    <message>
        <source>The plan can&apos;t be changed.</source>
        <translation>計画を変更できません。</translation>
    </message>
    <message>
        <source>The runs are not read</source>
        <translation>測定が読み込まれていません</translation>
    </message>
    <message>
        <source>Come back to this page to read them again.</source>
        <translation>このページに戻ると再度読み込みます。</translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>測定を記録するか、ログファイルを開いてください。</translation>
    </message>
    <message>
        <source>The runs can&apos;t be read.</source>
        <translation>測定を読み込めません。</translation>
    </message>
    <message>
        <source>Reading the runs</source>
        <translation>測定を読み込み中</translation>
    </message>
    <message>
        <source>Fitted curve, ±1 σ of its residuals</source>
        <translation>近似曲線、残差の ±1 σ</translation>
    </message>
    <message>
        <source>TDE, %1 (dps)</source>
        <translation>TDE、%1 (dps)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 と %2</translation>
    </message>
    <message>
        <source>%1, run %2</source>
        <translation>%1、測定 %2</translation>
    </message>
    <message>
        <source>%1, runs %2</source>
        <translation>%1、測定 %2</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>昇温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>TDE against the temperature quantities</source>
        <translation>温度量に対する TDE</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference from the holds</source>
        <translation>温度に対する %1 の TDE、基準は保持区間から</translation>
    </message>
    <message>
        <source>TDE of %1 against temperature, reference %2 dps</source>
        <translation>温度に対する %1 の TDE、基準 %2 dps</translation>
    </message>
    <message>
        <source>heating again</source>
        <translation>再昇温</translation>
    </message>
    <message>
        <source>heating</source>
        <translation>昇温</translation>
    </message>
    <message>
        <source>cooling again</source>
        <translation>再降温</translation>
    </message>
    <message>
        <source>cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>%1 dps (%2)</source>
        <translation>%1 dps (%2)</translation>
    </message>
    <message>
        <source>These runs can&apos;t be calibrated as they are.</source>
        <translation>これらの測定は、このままでは校正できません。</translation>
    </message>
    <message>
        <source>%1 is not a curve of temperature.</source>
        <translation>%1 は温度の関数ではありません。</translation>
    </message>
    <message>
        <source>No table over temperature can remove this.</source>
        <translation>温度に対するテーブルでは除去できません。</translation>
    </message>
    <message>
        <source>At %1 °C it reads %2.</source>
        <translation>%1 °C での値は %2 です。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>検出内容</translation>
    </message>
    <message>
        <source>all over</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Findings of the checks</source>
        <translation>チェックの指摘事項</translation>
    </message>
    <message>
        <source>Include</source>
        <translation>除外を解除</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Drag in the time strip to select a stretch first.</source>
        <translation>先に時間ストリップ上をドラッグして区間を選択してください。</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>指摘事項 (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>測定 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Can&apos;t be calibrated</source>
        <translation>校正不可</translation>
    </message>
    <message>
        <source>%1: hysteresis</source>
        <translation>%1：ヒステリシス</translation>
    </message>
    <message>
        <source>Drag in the time strip to select · Delete exclude · Ctrl+Z undo · X, Y, Z choose the axis · Double-click fit</source>
        <translation>時間ストリップをドラッグ 選択 · Delete 除外 · Ctrl+Z 元に戻す · X, Y, Z 軸を選択 · ダブルクリック 全体表示</translation>
    </message>
    <message>
        <source>%1, %2 samples at %3 Hz</source>
        <translation>%1、%2 サンプル、%3 Hz</translation>
    </message>
    <message>
        <source>%1 excluded</source>
        <translation>%1 除外</translation>
    </message>
    <message numerus="yes">
        <source>exclude %1 s in %n stretches</source>
        <translation>
            <numerusform>%n 区間の %1 s を除外</numerusform>
        </translation>
    </message>
    <message>
        <source>Each point is the mean of %1 samples</source>
        <translation>各点は %1 サンプルの平均</translation>
    </message>
</context>
<context>
    <name>driftbench::InspectSide</name>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>カバレッジ</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Excluded stretches</source>
        <translation>除外区間</translation>
    </message>
    <message>
        <source>Swing of TDE</source>
        <translation>TDE の変動幅</translation>
    </message>
    <message>
        <source>Noise within 0.5 °C</source>
        <translation>0.5 °C 内のノイズ</translation>
    </message>
    <message>
        <source>Left by the curve</source>
        <translation>曲線の残留分</translation>
    </message>
    <message>
        <source>That is</source>
        <translation>ノイズ比</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Heated and cooled</source>
        <translation>昇温・降温とも</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>A curve of T</source>
        <translation>T の関数</translation>
    </message>
    <message>
        <source>Nearly a curve of T</source>
        <translation>ほぼ T の関数</translation>
    </message>
    <message>
        <source>Not a curve of T</source>
        <translation>T の関数でない</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>spread at %1 °C</source>
        <translation>%1 °C での開き</translation>
    </message>
    <message>
        <source>swing</source>
        <translation>変動幅</translation>
    </message>
    <message>
        <source>%1 in figures</source>
        <translation>%1 の数値</translation>
    </message>
    <message>
        <source>%1 dps rms</source>
        <translation>%1 dps rms</translation>
    </message>
    <message>
        <source>%1 × the noise</source>
        <translation>ノイズの %1 倍</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1～%2 °C</translation>
    </message>
    <message>
        <source>%1 % of it</source>
        <translation>範囲の %1 %</translation>
    </message>
</context>
<context>
    <name>driftbench::IntervalPanel</name>
    <message>
        <source>Smallest rate step, ΔE&lt;sub&gt;S&lt;/sub&gt;</source>
        <translation>最小角速度ステップ ΔE&lt;sub&gt;S&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>mdps</source>
        <translation>mdps</translation>
    </message>
    <message>
        <source>Bias with T, γ′ = %1 × %2/%3</source>
        <translation>バイアス温度係数 γ′ = %1 × %2/%3</translation>
    </message>
    <message>
        <source>mdps/°C</source>
        <translation>mdps/°C</translation>
    </message>
    <message>
        <source>Sensitivity with T, β</source>
        <translation>感度温度係数 β</translation>
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
        <translation>採用（%1 以下）</translation>
    </message>
    <message>
        <source>used, but above %1</source>
        <translation>採用（ただし %1 超）</translation>
    </message>
    <message>
        <source>The paper prints β with the span squared, which gives %1 mdps/°C. Half the span gives the value it uses, %2.</source>
        <translation>論文の β の式ではスパンが 2 乗されており、%1 mdps/°C になります。スパンの半分とすると、論文で使われている値 %2 になります。</translation>
    </message>
</context>
<context>
    <name>driftbench::JudgedRunView</name>
    <message>
        <source>Held-out run before and after compensation, and its Allan deviation</source>
        <translation>検証用の測定の補償前後とそのアラン偏差</translation>
    </message>
    <message>
        <source>After, %1</source>
        <translation>補償後、%1</translation>
    </message>
    <message>
        <source>After, %1 trained on %2</source>
        <translation>補償後、%1（学習：%2）</translation>
    </message>
    <message>
        <source>Before, less the constant</source>
        <translation>補償前（定数差引き）</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>補償前</translation>
    </message>
    <message>
        <source>Limit ±%1 dps</source>
        <translation>許容値 ±%1 dps</translation>
    </message>
    <message>
        <source>TDE left (dps)</source>
        <translation>残留 TDE (dps)</translation>
    </message>
    <message>
        <source>Time in run</source>
        <translation>測定内の時間</translation>
    </message>
    <message>
        <source>After</source>
        <translation>補償後</translation>
    </message>
    <message>
        <source>Averaging time τ (s)</source>
        <translation>平均時間 τ (s)</translation>
    </message>
    <message>
        <source>σ(τ) (dps)</source>
        <translation>σ(τ) (dps)</translation>
    </message>
    <message>
        <source>lowest %1 before, %2 dps after</source>
        <translation>最小 補償前 %1、補償後 %2 dps</translation>
    </message>
    <message>
        <source>No run to judge</source>
        <translation>判定する測定なし</translation>
    </message>
    <message>
        <source>Train a model and choose a run that it has not seen.</source>
        <translation>モデルを学習し、学習に使っていない測定を選択してください。</translation>
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
        <translation>最大誤差
mdps</translation>
    </message>
    <message>
        <source>%1
code</source>
        <translation>%1
コード</translation>
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
        <translation>定温区間</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>計画</translation>
    </message>
    <message>
        <source>%1: samples missing, %2</source>
        <translation>%1：サンプル欠落、%2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n samples dropped, %2</source>
        <translation>
            <numerusform>%1：%n サンプル欠落、%2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::LiveRun</name>
    <message>
        <source>set the reference rate of the run that is recorded</source>
        <translation>記録中の測定の基準角速度を設定</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveStrips</name>
    <message>
        <source>%1 comp.</source>
        <translation>%1 補償後</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 生値</translation>
    </message>
</context>
<context>
    <name>driftbench::LiveTraceView</name>
    <message>
        <source>Raw, mean and range</source>
        <translation>生値、平均と範囲</translation>
    </message>
    <message>
        <source>Compensated</source>
        <translation>補償後</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>時間 (s)</translation>
    </message>
    <message>
        <source>%1, lowest</source>
        <translation>%1、最小</translation>
    </message>
    <message>
        <source>%1, mean</source>
        <translation>%1、平均</translation>
    </message>
    <message>
        <source>%1, highest</source>
        <translation>%1、最大</translation>
    </message>
    <message>
        <source>%1 raw (dps)</source>
        <translation>%1 生値 (dps)</translation>
    </message>
    <message>
        <source>%1 compensated (dps)</source>
        <translation>%1 補償後 (dps)</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>raw %1 dps</source>
        <translation>生値 %1 dps</translation>
    </message>
    <message>
        <source>compensated %1 dps</source>
        <translation>補償後 %1 dps</translation>
    </message>
    <message>
        <source>T %1 °C</source>
        <translation>T %1 °C</translation>
    </message>
    <message>
        <source>plan %1 °C</source>
        <translation>計画 %1 °C</translation>
    </message>
    <message>
        <source>Live traces</source>
        <translation>ライブ波形</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>経過時間 (h:min)</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>経過時間 (h:min:s)</translation>
    </message>
    <message>
        <source>%1 rate (dps)</source>
        <translation>%1 角速度 (dps)</translation>
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
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進捗</translation>
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
        <translation>方法</translation>
    </message>
    <message>
        <source>Gyro in the log</source>
        <translation>ログ内のジャイロ</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>時間の列</translation>
    </message>
    <message>
        <source>T column</source>
        <translation>T の列</translation>
    </message>
    <message>
        <source>x column</source>
        <translation>x の列</translation>
    </message>
    <message>
        <source>y column</source>
        <translation>y の列</translation>
    </message>
    <message>
        <source>z column</source>
        <translation>z の列</translation>
    </message>
    <message>
        <source>Time unit</source>
        <translation>時間の単位</translation>
    </message>
    <message>
        <source>T unit</source>
        <translation>T の単位</translation>
    </message>
    <message>
        <source>Rate unit</source>
        <translation>角速度の単位</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>感度</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>基準角速度</translation>
    </message>
    <message>
        <source>found by its name</source>
        <translation>名前で検出</translation>
    </message>
    <message>
        <source>The name in the header, or the number of the column.</source>
        <translation>ヘッダ内の名前、または列の番号です。</translation>
    </message>
    <message>
        <source>Read in whole</source>
        <translation>一括読み込み</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Play back, %1 times</source>
        <translation>%1 倍速で再生</translation>
    </message>
    <message>
        <source>The only one</source>
        <translation>唯一のもの</translation>
    </message>
    <message>
        <source>As the log says</source>
        <translation>ログに従う</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>センサ</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>as the log says</source>
        <translation>ログの記載どおり</translation>
    </message>
    <message>
        <source>Whose log it is: a device takes a table only for itself, and the report names it.</source>
        <translation>どのセンサのログか。デバイスは自分用のテーブルだけを受け付け、レポートにも記載されます。</translation>
    </message>
</context>
<context>
    <name>driftbench::MainWindow</name>
    <message>
        <source>Tab next · Enter choose · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>Tab 次へ · Enter 選択 · Ctrl+O ファイルを開く · Alt+1～7 ステップ</translation>
    </message>
    <message>
        <source>Event log</source>
        <translation>イベントログ</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>セッション(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;New session</source>
        <translation>新規セッション(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open files…</source>
        <translation>ファイルを開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近使ったファイル(&amp;R)</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Copy the event log</source>
        <translation>イベントログをコピー</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>配色(&amp;C)</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>システムに合わせる(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全画面表示(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Event log</source>
        <translation>イベントログ(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>スタートページ(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>ガイドツアー(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Driftbench</source>
        <translation>Driftbench について(&amp;A)</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Qt について(&amp;Q)</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>ファイルなし</translation>
    </message>
    <message>
        <source>&amp;Save session…</source>
        <translation>セッションを保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>セッションを保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>元に戻す(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>やり直す(&amp;R)：%1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>全般</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Wheel|Zoom at the mouse; over an axis, that axis</source>
        <translation>ホイール|マウス位置でズーム、軸上ではその軸のみ</translation>
    </message>
    <message>
        <source>Drag|Move</source>
        <translation>ドラッグ|移動</translation>
    </message>
    <message>
        <source>Shift+Drag|Zoom to a box</source>
        <translation>Shift+ドラッグ|枠で囲んでズーム</translation>
    </message>
    <message>
        <source>Double-click, F|Fit</source>
        <translation>ダブルクリック, F|全体表示</translation>
    </message>
    <message>
        <source>Arrows|Move</source>
        <translation>矢印キー|移動</translation>
    </message>
    <message>
        <source>+, −|Zoom</source>
        <translation>+, −|ズーム</translation>
    </message>
    <message>
        <source>A, B|Set a cursor at the mouse</source>
        <translation>A, B|マウス位置にカーソルを設定</translation>
    </message>
    <message>
        <source>Ctrl+E|Export what is visible</source>
        <translation>Ctrl+E|表示範囲をエクスポート</translation>
    </message>
    <message>
        <source>About Driftbench</source>
        <translation>Driftbench について</translation>
    </message>
    <message>
        <source>Driftbench %1</source>
        <translation>Driftbench %1</translation>
    </message>
    <message>
        <source>Calibrates the temperature drift of MEMS gyros. Free software under the GNU General Public License, version 3 or later.</source>
        <translation>MEMS ジャイロの温度ドリフトを校正します。GNU 一般公衆利用許諾書（GPL）バージョン 3 以降に基づく自由ソフトウェアです。</translation>
    </message>
    <message>
        <source>Open logs or a session</source>
        <translation>ログまたはセッションを開く</translation>
    </message>
    <message>
        <source>Logs and sessions (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;All files (*)</source>
        <translation>ログとセッション (*.csv *.tsv *.txt *.ulg *.bin *.BIN *.log *.driftbench);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>セッションを保存</translation>
    </message>
    <message>
        <source>Sessions (*.driftbench)</source>
        <translation>セッション (*.driftbench)</translation>
    </message>
    <message>
        <source>New session, not saved yet</source>
        <translation>新規セッション、未保存</translation>
    </message>
    <message>
        <source>Unnamed session</source>
        <translation>名称未設定のセッション</translation>
    </message>
    <message>
        <source>Session: %1</source>
        <translation>セッション：%1</translation>
    </message>
    <message>
        <source>%1 · read-only</source>
        <translation>%1 · 読み取り専用</translation>
    </message>
    <message>
        <source>%1 · saved</source>
        <translation>%1 · 保存済み</translation>
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
        <translation>%1～%2 s に途切れ：%3。</translation>
    </message>
    <message>
        <source>Session restored.</source>
        <translation>セッションを復元しました。</translation>
    </message>
    <message>
        <source>Recording stopped when the program ended. %1 samples are safe.</source>
        <translation>プログラムの終了時に記録が停止しました。%1 サンプルは無事です。</translation>
    </message>
    <message>
        <source>It has no name yet; Save gives it one.</source>
        <translation>名前がまだありません。保存時に名前を付けられます。</translation>
    </message>
    <message>
        <source>Quit Driftbench</source>
        <translation>Driftbench の終了</translation>
    </message>
    <message>
        <source>A run is being recorded.</source>
        <translation>測定を記録中です。</translation>
    </message>
    <message>
        <source>The last changes are not on the disk.</source>
        <translation>最後の変更がディスクに保存されていません。</translation>
    </message>
    <message>
        <source>Quit ends the run. What was recorded is kept.</source>
        <translation>終了すると測定も終わります。記録済みの内容は保持されます。</translation>
    </message>
    <message>
        <source>Make room or permit the file to be written, then save again.</source>
        <translation>空き容量を確保するかファイルへの書き込みを許可し、再度保存してください。</translation>
    </message>
    <message>
        <source>End the run and quit</source>
        <translation>測定を終えて終了</translation>
    </message>
    <message>
        <source>Quit and lose them</source>
        <translation>変更を破棄して終了</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>続行</translation>
    </message>
    <message>
        <source>%1 is running.</source>
        <extracomment>%1 is the name of a source</extracomment>
        <translation>%1 が動作中です。</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelLabels</name>
    <message>
        <source>RBF network</source>
        <translation>RBF ネットワーク</translation>
    </message>
    <message>
        <source>RBF network, as in the paper</source>
        <translation>RBF ネットワーク、論文どおり</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>BP ネットワーク</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>3 次式</translation>
    </message>
    <message>
        <source>cubic, as ArduPilot</source>
        <translation>3 次式、ArduPilot 方式</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直線</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>定数</translation>
    </message>
    <message>
        <source>recommended model of each axis</source>
        <translation>各軸の推奨モデル</translation>
    </message>
</context>
<context>
    <name>driftbench::ModelWords</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>RBF network (Novel)</source>
        <translation>RBF ネットワーク（提案法）</translation>
    </message>
    <message>
        <source>BP 2-%1-1 (Conv. 2)</source>
        <translation>BP 2-%1-1（従来法 2）</translation>
    </message>
    <message>
        <source>Cubic (PX4)</source>
        <translation>3 次式（PX4）</translation>
    </message>
    <message>
        <source>Cubic (ArduPilot)</source>
        <translation>3 次式（ArduPilot）</translation>
    </message>
    <message>
        <source>Line (Conv. 1)</source>
        <translation>直線（従来法 1）</translation>
    </message>
    <message>
        <source>Constant (bias only)</source>
        <translation>定数（バイアスのみ）</translation>
    </message>
    <message numerus="yes">
        <source>%n centres</source>
        <translation>
            <numerusform>中心数 %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 to %2 centres</source>
        <translation>中心数 %1～%2</translation>
    </message>
    <message>
        <source>RBF, %1 (Novel)</source>
        <translation>RBF、%1（提案法）</translation>
    </message>
    <message>
        <source>RBF, paper (Novel)</source>
        <translation>論文どおりの RBF（提案法）</translation>
    </message>
    <message>
        <source>RBF, paper, %1</source>
        <translation>論文どおりの RBF、%1</translation>
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
        <translation>ノイズフロア</translation>
    </message>
    <message>
        <source>Excess %1
%</source>
        <translation>超過分 %1
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
        <translation>モデル</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>所要時間</translation>
    </message>
</context>
<context>
    <name>driftbench::MsdTrendView</name>
    <message>
        <source>MSD so far</source>
        <translation>これまでの MSD</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>データなし</translation>
    </message>
    <message>
        <source>It begins with the recording.</source>
        <translation>記録とともに始まります。</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>経過時間 (h:min:s)</translation>
    </message>
    <message>
        <source>Time since start (h:min)</source>
        <translation>経過時間 (h:min)</translation>
    </message>
    <message>
        <source>%1 before</source>
        <translation>%1 補償前</translation>
    </message>
    <message>
        <source>%1 after</source>
        <translation>%1 補償後</translation>
    </message>
</context>
<context>
    <name>driftbench::NativeForm</name>
    <message>
        <source>As it is set</source>
        <translation>現在の設定のまま</translation>
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
        <translation>サンプルレート</translation>
    </message>
    <message>
        <source>0 leaves the rate that the bridge has now.</source>
        <translation>0 でブリッジの現在のレートを維持します。</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>レンジ</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>温度計</translation>
    </message>
    <message>
        <source>External, else die</source>
        <translation>外付け、なければダイ</translation>
    </message>
    <message>
        <source>External</source>
        <translation>外付け</translation>
    </message>
    <message>
        <source>On the die</source>
        <translation>ダイ上</translation>
    </message>
    <message>
        <source>Compensated by its own table</source>
        <translation>内蔵テーブルで補償</translation>
    </message>
    <message>
        <source>To check a table that was written. A calibration needs raw rates.</source>
        <translation>書き込んだテーブルの確認用です。校正には生の角速度が必要です。</translation>
    </message>
</context>
<context>
    <name>driftbench::OriginChip</name>
    <message>
        <source>Simulated data</source>
        <translation>模擬データ</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>実ログ</translation>
    </message>
    <message>
        <source>Real device</source>
        <translation>実機</translation>
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
        <translation>なし</translation>
    </message>
    <message>
        <source>As printed (kJ, °C)</source>
        <translation>論文どおり (kJ, °C)</translation>
    </message>
    <message>
        <source>In SI, °C; in SI, kelvin</source>
        <translation>SI (°C); SI (K)</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Slowest mode of a %1 m cube, still air</source>
        <translation>%1 m 立方体の最遅モード、静止空気</translation>
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
        <translation>センサ</translation>
    </message>
    <message>
        <source>Chamber</source>
        <translation>恒温槽</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>プロファイル</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>レンジ</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>感度</translation>
    </message>
    <message>
        <source>Bias with T</source>
        <translation>バイアス温度係数</translation>
    </message>
    <message>
        <source>Inner length</source>
        <translation>内寸</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>温度計</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>開始、終了</translation>
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
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Hold at the ends</source>
        <translation>両端での保持</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Come back down, to see hysteresis</source>
        <translation>降温してヒステリシスも見る</translation>
    </message>
    <message>
        <source>Own figures</source>
        <translation>任意の値</translation>
    </message>
    <message>
        <source>%1 dps</source>
        <translation>%1 dps</translation>
    </message>
    <message>
        <source>Sensor preset</source>
        <translation>センサのプリセット</translation>
    </message>
    <message>
        <source>Chamber preset</source>
        <translation>恒温槽のプリセット</translation>
    </message>
</context>
<context>
    <name>driftbench::PlanPage</name>
    <message>
        <source>edit of the plan</source>
        <translation>計画の編集</translation>
    </message>
    <message>
        <source>%1 to %2 °C</source>
        <translation>%1～%2 °C</translation>
    </message>
    <message>
        <source>None, from a log</source>
        <translation>なし（ログから）</translation>
    </message>
    <message>
        <source>Tab next field · Up, Down change a value · Ctrl+Z undo · Ctrl+Enter record</source>
        <translation>Tab 次の欄 · ↑, ↓ 値を変更 · Ctrl+Z 元に戻す · Ctrl+Enter 記録</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>この計画を使用</translation>
    </message>
    <message>
        <source>Plan file</source>
        <translation>計画ファイル</translation>
    </message>
    <message>
        <source>Open plan…</source>
        <translation>計画を開く…</translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation>計画を保存…</translation>
    </message>
    <message>
        <source>Save steps for a chamber controller…</source>
        <translation>恒温槽コントローラ用ステップを保存…</translation>
    </message>
    <message>
        <source>Save ramps for a chamber controller…</source>
        <translation>恒温槽コントローラ用ランプを保存…</translation>
    </message>
    <message>
        <source>One run</source>
        <translation>1 回の測定</translation>
    </message>
    <message>
        <source>Control interval</source>
        <translation>制御間隔</translation>
    </message>
    <message>
        <source>Eqs. 13, 14, 26, 27</source>
        <translation>式 13、14、26、27</translation>
    </message>
    <message>
        <source>Control period</source>
        <translation>制御周期</translation>
    </message>
    <message>
        <source>Eqs. 25, 28, and the transient</source>
        <translation>式 25、28 と過渡応答</translation>
    </message>
    <message>
        <source>, without cooling back</source>
        <translation>、降温なし</translation>
    </message>
    <message>
        <source>What the chamber does in each run, and for how long</source>
        <translation>各測定での恒温槽の動作とその時間</translation>
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
        <translation>%1 のステップは、静止空気の整定時間 %2 より短くなっています。</translation>
    </message>
    <message>
        <source>Stir the air, or place the thermometer on the sensor.</source>
        <translation>空気を撹拌するか、温度計をセンサに取り付けてください。</translation>
    </message>
    <message>
        <source>Open plan</source>
        <translation>計画を開く</translation>
    </message>
    <message>
        <source>Plans (*.json)</source>
        <translation>計画 (*.json)</translation>
    </message>
    <message>
        <source>Plan read from %1.</source>
        <translation>%1 から計画を読み込みました。</translation>
    </message>
    <message>
        <source>Save plan</source>
        <translation>計画を保存</translation>
    </message>
    <message>
        <source>Plan written to %1.</source>
        <translation>計画を %1 に保存しました。</translation>
    </message>
    <message>
        <source>Save controller file</source>
        <translation>コントローラファイルを保存</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>Controller file written to %1.</source>
        <translation>コントローラファイルを %1 に保存しました。</translation>
    </message>
    <message numerus="yes">
        <source>%1 a run, %2 samples at %3 Hz · %4 for %n runs</source>
        <translation>
            <numerusform>1 測定 %1、%2 サンプル、%3 Hz · %n 測定で %4</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::PlotInteraction</name>
    <message>
        <source>Fit</source>
        <translation>全体表示</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Set cursor A here</source>
        <translation>ここにカーソル A を設定</translation>
    </message>
    <message>
        <source>Set cursor B here</source>
        <translation>ここにカーソル B を設定</translation>
    </message>
    <message>
        <source>Remove the cursors</source>
        <translation>カーソルを消去</translation>
    </message>
    <message>
        <source>Export what is visible…</source>
        <translation>表示範囲をエクスポート…</translation>
    </message>
    <message>
        <source>Show the data as a table</source>
        <translation>データを表で表示</translation>
    </message>
    <message>
        <source>Export what is visible</source>
        <translation>表示範囲をエクスポート</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG 図形 (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文書 (*.pdf)</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV 表 (*.csv)</translation>
    </message>
</context>
<context>
    <name>driftbench::PlotTable</name>
    <message>
        <source>Panel</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>横軸</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
</context>
<context>
    <name>driftbench::ProfileView</name>
    <message>
        <source>Set points of one run over time</source>
        <translation>1 回の測定の設定温度の時系列</translation>
    </message>
    <message>
        <source>hold %1</source>
        <translation>保持 %1</translation>
    </message>
    <message>
        <source>No profile</source>
        <translation>プロファイルなし</translation>
    </message>
    <message>
        <source>Put the fields right that are marked.</source>
        <translation>印の付いた欄を修正してください。</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>経過時間</translation>
    </message>
    <message>
        <source>Set point (°C)</source>
        <translation>設定温度 (°C)</translation>
    </message>
    <message numerus="yes">
        <source>%n steps of %1 °C, %2 °C/min</source>
        <translation>
            <numerusform>%1 °C × %n ステップ、%2 °C/min</numerusform>
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
        <translation>基準角速度、%1</translation>
    </message>
</context>
<context>
    <name>driftbench::RecentFilesModel</name>
    <message>
        <source>Ready to train</source>
        <translation>学習可能</translation>
    </message>
    <message>
        <source>Single run</source>
        <translation>測定 1 件のみ</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>Real</source>
        <translation>実測</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>調査中…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>由来</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>Expect</source>
        <translation>見込み</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n runs</source>
        <translation>
            <numerusform>測定 %1/%n 件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n runs</source>
        <translation>
            <numerusform>測定 %n 件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::RecordPage</name>
    <message>
        <source>Span of the traces</source>
        <translation>波形の表示幅</translation>
    </message>
    <message>
        <source>Quantity of the traces</source>
        <translation>波形の量</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>記録を開始</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>記録を停止</translation>
    </message>
    <message>
        <source>Choose a source</source>
        <translation>ソースを選択</translation>
    </message>
    <message>
        <source>Inspect</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Write again</source>
        <translation>再書き込み</translation>
    </message>
    <message>
        <source>Save it elsewhere…</source>
        <translation>別の場所に保存…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>測定</translation>
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
        <translation>角速度</translation>
    </message>
    <message>
        <source>TDE</source>
        <translation>TDE</translation>
    </message>
    <message>
        <source>No source is chosen.</source>
        <translation>ソースが選択されていません。</translation>
    </message>
    <message>
        <source>Choose the bridge or the file to record from.</source>
        <translation>記録元のブリッジまたはファイルを選択してください。</translation>
    </message>
    <message>
        <source>The run can&apos;t be recorded.</source>
        <translation>測定を記録できません。</translation>
    </message>
    <message>
        <source>The source has ended.</source>
        <translation>ソースが終了しました。</translation>
    </message>
    <message>
        <source>Run %1 is complete.</source>
        <translation>測定 %1 が完了しました。</translation>
    </message>
    <message>
        <source>Run %1 was stopped at %2.</source>
        <translation>測定 %1 を %2 で停止しました。</translation>
    </message>
    <message>
        <source>%1 samples are in the session.</source>
        <translation>%1 サンプルがセッションにあります。</translation>
    </message>
    <message>
        <source>A part of the run is not on the disk.</source>
        <translation>測定の一部がディスクにありません。</translation>
    </message>
    <message>
        <source>It is kept in memory.</source>
        <translation>メモリに保持しています。</translation>
    </message>
    <message>
        <source>The disk is slow.</source>
        <translation>ディスクが低速です。</translation>
    </message>
    <message>
        <source>The disk takes no more.</source>
        <translation>ディスクに書き込めません。</translation>
    </message>
    <message>
        <source>Make room on it; recording goes on in memory.</source>
        <translation>空き容量を確保してください。記録はメモリ上で続きます。</translation>
    </message>
    <message>
        <source>All samples are on the disk again.</source>
        <translation>全サンプルが再びディスクに保存されました。</translation>
    </message>
    <message>
        <source>The memory for samples is full, the run has ended.</source>
        <translation>サンプル用のメモリが一杯になり、測定を終了しました。</translation>
    </message>
    <message>
        <source>Save what is not on the disk</source>
        <translation>ディスクにない分を保存</translation>
    </message>
    <message>
        <source>CSV log (*.csv)</source>
        <translation>CSV ログ (*.csv)</translation>
    </message>
    <message>
        <source>The rest of the run is in %1.</source>
        <translation>測定の残りは %1 にあります。</translation>
    </message>
    <message>
        <source>The view is paused at %1. Recording goes on.</source>
        <translation>表示を %1 で一時停止中です。記録は続いています。</translation>
    </message>
    <message>
        <source>%1 samples have arrived since. The figures on the right stay live.</source>
        <translation>その後 %1 サンプルを受信しました。右側の数値は更新され続けます。</translation>
    </message>
    <message>
        <source>The bridge was unplugged at %1.</source>
        <translation>ブリッジが %1 に取り外されました。</translation>
    </message>
    <message>
        <source>Plug it in to go on with this run.</source>
        <translation>接続するとこの測定を続行できます。</translation>
    </message>
    <message>
        <source>No samples have come for %1 s.</source>
        <translation>%1 s の間サンプルが届いていません。</translation>
    </message>
    <message>
        <source>Look at the cable and the bridge; the run goes on as soon as they come again.</source>
        <translation>ケーブルとブリッジを調べてください。再び届けば測定は続行します。</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>測定 %1/%2</translation>
    </message>
    <message>
        <source>%1, no model yet</source>
        <translation>%1、モデルなし</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>%1, compensated by the model of %2</source>
        <translation>%1、%2 のモデルで補償</translation>
    </message>
    <message>
        <source>Resume view</source>
        <translation>表示を再開</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>表示を一時停止</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s) in the session</source>
        <translation>
            <numerusform>セッション内の測定 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>No runs yet</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>Record the next run from: %1.</source>
        <translation>次の測定の記録元：%1。</translation>
    </message>
    <message>
        <source>Choose a source, then record a run.</source>
        <translation>ソースを選択し、測定を記録してください。</translation>
    </message>
    <message>
        <source>%1 · %2 %</source>
        <translation>%1 · %2 %</translation>
    </message>
    <message>
        <source>Opening the source</source>
        <translation>ソースに接続中</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>測定 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Space resume the view · Wheel zoom · Drag pan · A, B set a cursor at the mouse</source>
        <translation>Space 表示を再開 · ホイール ズーム · ドラッグ 移動 · A, B マウス位置にカーソルを設定</translation>
    </message>
    <message>
        <source>Wheel zoom · Drag pan · Shift+drag box zoom · Double-click fit · A, B set a cursor at the mouse</source>
        <translation>ホイール ズーム · ドラッグ 移動 · Shift+ドラッグ 枠でズーム · ダブルクリック 全体表示 · A, B マウス位置にカーソルを設定</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 と %2</translation>
    </message>
</context>
<context>
    <name>driftbench::RecordReadouts</name>
    <message>
        <source>Progress</source>
        <translation>進捗</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>測定の進捗</translation>
    </message>
    <message>
        <source>Running MSD</source>
        <translation>逐次 MSD</translation>
    </message>
    <message>
        <source>dps², since 0:00:00</source>
        <translation>dps²、0:00:00 から</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>カーソル</translation>
    </message>
    <message>
        <source>10 s means, dps</source>
        <translation>10 s 平均、dps</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>MSD so far</source>
        <translation>これまでの MSD</translation>
    </message>
    <message>
        <source>dps², amber before, blue after</source>
        <translation>dps²、橙：補償前、青：補償後</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>経過</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>残り</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>計画</translation>
    </message>
    <message>
        <source>before</source>
        <translation>補償前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>補償後</translation>
    </message>
    <message>
        <source>Q = after/before</source>
        <translation>Q = 後/前</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>T (°C)</source>
        <translation>T (°C)</translation>
    </message>
    <message>
        <source>%1 raw</source>
        <translation>%1 生値</translation>
    </message>
    <message>
        <source>%1 comp.</source>
        <translation>%1 補償後</translation>
    </message>
    <message>
        <source>Sample rate, samples</source>
        <translation>サンプルレート、サンプル</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>Overruns, saturated</source>
        <translation>オーバーラン、飽和</translation>
    </message>
    <message>
        <source>rise, step %1 of %2</source>
        <translation>昇温、ステップ %1/%2</translation>
    </message>
    <message>
        <source>fall, step %1 of %2</source>
        <translation>降温、ステップ %1/%2</translation>
    </message>
    <message>
        <source>hold, step %1 of %2</source>
        <translation>保持、ステップ %1/%2</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1, %2 off</source>
        <translation>%1、%2 ずれ</translation>
    </message>
    <message>
        <source>%1, %2 ahead</source>
        <translation>%1、%2 先行</translation>
    </message>
    <message>
        <source>%1, %2 behind</source>
        <translation>%1、%2 遅れ</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>定温区間</translation>
    </message>
    <message>
        <source>rms of 10 s means, before and after:</source>
        <translation>10 s 平均の rms、補償前と補償後：</translation>
    </message>
    <message>
        <source>%1: %2 and %3 dps</source>
        <translation>%1：%2 と %3 dps</translation>
    </message>
    <message>
        <source>last gap %1</source>
        <translation>直近の途切れ %1</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
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
        <translation>%1（他の測定で学習）</translation>
    </message>
    <message>
        <source>%1 trained on %2</source>
        <translation>%1（学習：%2）</translation>
    </message>
    <message>
        <source>Temperature quantities and drift error over time</source>
        <translation>温度量とドリフト誤差の時系列</translation>
    </message>
    <message>
        <source>Run %1: ΔT, ΔT² and √ΔT, and the temperature drift error (TDE) of each axis.</source>
        <translation>測定 %1：ΔT、ΔT²、√ΔT と各軸の温度ドリフト誤差（TDE）。</translation>
    </message>
    <message>
        <source>TDE of %1 against each temperature quantity</source>
        <translation>各温度量に対する %1 の TDE</translation>
    </message>
    <message>
        <source>All runs, with the curves fitted to them; below, what the fitted curve leaves. Where heating and cooling part, no curve of temperature follows.</source>
        <translation>全測定とその近似曲線です。下段は近似曲線の残差です。昇温と降温で分かれる箇所は、温度の関数では表せません。</translation>
    </message>
    <message>
        <source>Run %1 before and after compensation</source>
        <translation>測定 %1 の補償前後</translation>
    </message>
    <message>
        <source>The model has not seen this run. Mean, and lowest to highest, of each stretch of time; rms about the reference rate.</source>
        <translation>モデルはこの測定を学習に使っていません。時間区間ごとの平均と最小～最大、rms は基準角速度に対する値です。</translation>
    </message>
    <message>
        <source>Allan deviation of run %1</source>
        <translation>測定 %1 のアラン偏差</translation>
    </message>
    <message>
        <source>Noise falls with the averaging time, drift rises with it.</source>
        <translation>平均時間が長くなるとノイズは減り、ドリフトは増えます。</translation>
    </message>
    <message>
        <source>Run %1, held out: what is left, and its Allan deviation</source>
        <translation>検証用の測定 %1：残留分とそのアラン偏差</translation>
    </message>
    <message>
        <source>Before, less the constant; after, by a model that has not seen this run. Each axis has its own scale.</source>
        <translation>補償前は定数を差し引いた値、補償後はこの測定を学習に使っていないモデルによる値です。縦軸は軸ごとに異なります。</translation>
    </message>
    <message>
        <source>What is left of the TDE on runs held out</source>
        <translation>検証用の測定での残留 TDE</translation>
    </message>
    <message>
        <source>Each run less the model that has not seen it. Lines that are level at zero mean that the drift repeats.</source>
        <translation>各測定から、それを学習に使っていないモデルを差し引いたものです。線がゼロで平坦なら、ドリフトに再現性があります。</translation>
    </message>
    <message>
        <source>How many centres the RBF network needs</source>
        <translation>RBF ネットワークに必要な中心数</translation>
    </message>
    <message>
        <source>The smallest number whose loss on data left out is as good as the lowest; below, where the centres stand.</source>
        <translation>検証データでの損失が最小値と同等になる最小の数です。下段は中心の位置です。</translation>
    </message>
    <message>
        <source>Simulated data</source>
        <translation>模擬データ</translation>
    </message>
    <message>
        <source>%1 held out</source>
        <translation>%1 を検証に使用</translation>
    </message>
    <message>
        <source>Blocks of temperature held out in turn</source>
        <translation>温度ブロックを順に検証に使用</translation>
    </message>
    <message>
        <source>Each run held out once</source>
        <translation>各測定を 1 回ずつ検証に使用</translation>
    </message>
    <message>
        <source>Anchored: the bias at the start of each run is removed</source>
        <translation>始点基準：各測定の開始時のバイアスを除去</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts</source>
        <translation>絶対：起動時バイアスを含む</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>センサ</translation>
    </message>
    <message>
        <source>not stated by the logs</source>
        <translation>ログに記載なし</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>Date of this report</source>
        <translation>レポート日付</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>%1, with %2 samples, %3 of them usable</source>
        <translation>%1、%2 サンプル（有効 %3）</translation>
    </message>
    <message>
        <source>Reference temperature</source>
        <translation>基準温度</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>Hold-out</source>
        <translation>検証方法</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>%1 dps rms may be left on a held-out run</source>
        <translation>検証用の測定での残留は %1 dps rms まで</translation>
    </message>
    <message>
        <source>none was set</source>
        <translation>設定なし</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Where the data come from</source>
        <translation>データの由来</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>ソース</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Reference dps</source>
        <translation>基準 dps</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>有効</translation>
    </message>
    <message>
        <source>Left out, and why</source>
        <translation>除外分とその理由</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Means over the held-out runs.</source>
        <translation>検証用の測定での平均です。</translation>
    </message>
    <message>
        <source>Held-out runs, in the paper&apos;s order</source>
        <translation>検証用の測定、論文の順</translation>
    </message>
    <message>
        <source>MSD in dps²: mean square of what is left. Q: MSD after over MSD before. Differences: negative where the first named is better. Novel: %1.</source>
        <translation>MSD の単位は dps²：残留分の 2 乗平均です。Q：補償後の MSD を補償前の MSD で割った値です。差：負なら先に記した方が優れています。提案法：%1。</translation>
    </message>
    <message>
        <source>Conventional 1 is a line in ΔT, Conventional 2 a BP network 2-10-1, Novel an RBF network on ΔT, ΔT² and √ΔT; cubic is the model of PX4 and ArduPilot, constant the bias alone.</source>
        <translation>従来法 1 は ΔT の直線、従来法 2 は BP ネットワーク 2-10-1、提案法は ΔT、ΔT²、√ΔT を入力とする RBF ネットワークです。3 次式は PX4 と ArduPilot のモデル、定数はバイアスのみです。</translation>
    </message>
    <message>
        <source>Yes: within the limit and better than the constant on every held-out run. With care: within the limit, but not always better. No: over the limit on any run, or the bias does not repeat.</source>
        <translation>可：検証用の測定すべてで許容値以内、かつ定数より優れています。要注意：許容値以内ですが、常に優れているとは限りません。不可：いずれかの測定で許容値を超えるか、バイアスに再現性がありません。</translation>
    </message>
    <message>
        <source>Real log</source>
        <translation>実ログ</translation>
    </message>
    <message>
        <source>unknown sensor</source>
        <translation>不明なセンサ</translation>
    </message>
    <message>
        <source>Temperature drift of %1, simulated</source>
        <translation>%1 の温度ドリフト（模擬）</translation>
    </message>
    <message>
        <source>Temperature drift of %1</source>
        <translation>%1 の温度ドリフト</translation>
    </message>
    <message>
        <source>May this drift be compensated?</source>
        <translation>このドリフトは補償してよいか</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>図</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>%1 ページ</translation>
    </message>
    <message>
        <source>Each model estimates the rate error as a function of temperature alone and is judged only on runs that it has not seen. %1. The noise floor is the variance within 0.5 °C: what no function of temperature removes. Excess is what a model leaves above it.</source>
        <translation>各モデルは温度のみの関数として角速度誤差を推定し、学習に使っていない測定でのみ判定されます。%1。ノイズフロアは 0.5 °C 内の分散で、温度の関数では除去できない分です。超過分は、モデルの残留のうちそれを上回る分です。</translation>
    </message>
</context>
<context>
    <name>driftbench::ReportWriter</name>
    <message>
        <source>Preparing</source>
        <translation>準備中</translation>
    </message>
    <message>
        <source>Drawing figure %1 of %2</source>
        <translation>図 %1/%2 を描画中</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>書き込み中</translation>
    </message>
</context>
<context>
    <name>driftbench::ResidualView</name>
    <message>
        <source>Residual against temperature</source>
        <translation>温度に対する残差</translation>
    </message>
    <message>
        <source>No residuals yet</source>
        <translation>残差なし</translation>
    </message>
    <message>
        <source>Train a model and choose runs that it has not seen.</source>
        <translation>モデルを学習し、学習に使っていない測定を選択してください。</translation>
    </message>
    <message>
        <source>Mean over 1 °C, each run</source>
        <translation>1 °C ごとの平均、各測定</translation>
    </message>
    <message>
        <source>95 % band of a new run&apos;s curve</source>
        <translation>新しい測定の曲線の 95 % 帯</translation>
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
        <translation>昇温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>除外</translation>
    </message>
</context>
<context>
    <name>driftbench::Session</name>
    <message>
        <source>unnamed</source>
        <translation>名称未設定</translation>
    </message>
</context>
<context>
    <name>driftbench::ShortcutOverview</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>What they do</source>
        <translation>動作</translation>
    </message>
</context>
<context>
    <name>driftbench::SimulatedForm</name>
    <message>
        <source>Curved</source>
        <translation>曲線的</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>急峻</translation>
    </message>
    <message>
        <source>Mild</source>
        <translation>緩やか</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Combs</source>
        <translation>櫛歯</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>実時間</translation>
    </message>
    <message>
        <source>As fast as it goes</source>
        <translation>最高速</translation>
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
        <translation>センサ</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>ドリフト</translation>
    </message>
    <message>
        <source>Reference rate</source>
        <translation>基準角速度</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>サンプルレート</translation>
    </message>
    <message>
        <source>Noise, 1 σ</source>
        <translation>ノイズ、1 σ</translation>
    </message>
    <message>
        <source>Run-to-run spread</source>
        <translation>測定間のばらつき</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>How fast the simulated time passes while a run is recorded.</source>
        <translation>測定の記録中に模擬時間が進む速さです。</translation>
    </message>
    <message>
        <source>How the bias follows the temperature; Combs computes it from the comb capacitors.</source>
        <translation>バイアスの温度依存性です。「櫛歯」は櫛歯容量から計算します。</translation>
    </message>
    <message>
        <source>%1, %2 dps</source>
        <translation>%1, %2 dps</translation>
    </message>
    <message>
        <source>%1, drift: %2</source>
        <translation>%1、ドリフト：%2</translation>
    </message>
</context>
<context>
    <name>driftbench::SourceForm</name>
    <message>
        <source>No source chosen</source>
        <translation>ソース未選択</translation>
    </message>
</context>
<context>
    <name>driftbench::SourcePage</name>
    <message>
        <source>Reading</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>Reading logs</source>
        <translation>ログを読み込み中</translation>
    </message>
    <message>
        <source>Simulated bridge</source>
        <translation>模擬ブリッジ</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>ジャイロブリッジ</translation>
    </message>
    <message>
        <source>I2C bridge</source>
        <translation>I2C ブリッジ</translation>
    </message>
    <message>
        <source>Up, Down choose · Enter use · F5 look again · Ctrl+O open files · Alt+1 to 7 steps</source>
        <translation>↑, ↓ 選択 · Enter 使用 · F5 再検索 · Ctrl+O ファイルを開く · Alt+1～7 ステップ</translation>
    </message>
    <message>
        <source>%1 %2 is plugged in, but you may not open it.</source>
        <translation>%1 %2 が接続されていますが、開く権限がありません。</translation>
    </message>
    <message>
        <source>Save this line as 70-driftbench.rules in /etc/udev/rules.d, then unplug the bridge and plug it in again:</source>
        <translation>次の行を 70-driftbench.rules として /etc/udev/rules.d に保存し、ブリッジを抜き差ししてください：</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Use source</source>
        <translation>ソースを使用</translation>
    </message>
    <message>
        <source>Choose a bridge or a file.</source>
        <translation>ブリッジかファイルを選択してください。</translation>
    </message>
    <message>
        <source>Use simulated bridge</source>
        <translation>模擬ブリッジを使用</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 を使用</translation>
    </message>
    <message>
        <source>Open session</source>
        <translation>セッションを開く</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Read in</source>
        <translation>読み込み</translation>
    </message>
    <message>
        <source>Other logs are being read.</source>
        <translation>他のログを読み込み中です。</translation>
    </message>
    <message>
        <source>A run is being recorded. Stop it to take another source.</source>
        <translation>測定を記録中です。別のソースを使うには停止してください。</translation>
    </message>
    <message>
        <source>Where the samples come from. Nothing is recorded yet.</source>
        <translation>サンプルの取得元です。記録はまだありません。</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>再検索</translation>
    </message>
    <message>
        <source>Copy line</source>
        <translation>行をコピー</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>ブリッジ</translation>
    </message>
    <message>
        <source>USB-HID, looked for every second</source>
        <translation>USB-HID、毎秒検索</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近使ったファイル</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>直近 60 s</translation>
    </message>
    <message>
        <source>Drop log files here: CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>ログファイルをここにドロップ：CSV、PX4 ULog、ArduPilot DataFlash。形式は内容から判別します。</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>ファイルなし</translation>
    </message>
    <message>
        <source>Logs and sessions that were opened stand here.</source>
        <translation>開いたログとセッションがここに表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n logs</source>
        <translation>
            <numerusform>ログ %n 件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n bridges plugged in, %1 usable</source>
        <translation>
            <numerusform>接続済みのブリッジ %n 台、使用可能 %1 台</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Where the samples come from. %n runs so far.</source>
        <translation>
            <numerusform>サンプルの取得元です。現在の測定は %n 件です。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::SourceStatus</name>
    <message>
        <source> · opening</source>
        <translation> · 接続中</translation>
    </message>
    <message>
        <source> · no samples for %1 s</source>
        <translation> · %1 s 間サンプルなし</translation>
    </message>
    <message>
        <source> · %1 Hz</source>
        <translation> · %1 Hz</translation>
    </message>
    <message>
        <source> · 0 dropped</source>
        <translation> · 欠落 0</translation>
    </message>
    <message>
        <source>%1 dropped of %2</source>
        <translation>%2 中 %1 欠落</translation>
    </message>
    <message>
        <source>%1 GB free</source>
        <translation>空き %1 GB</translation>
    </message>
</context>
<context>
    <name>driftbench::StartPage</name>
    <message>
        <source>Calibrate the temperature drift of a gyro</source>
        <translation>ジャイロの温度ドリフトを校正</translation>
    </message>
    <message>
        <source>From samples to a table in the device, in seven steps. Each step can be used on its own.</source>
        <translation>サンプルの取得からデバイス内のテーブルまで 7 ステップです。各ステップは単独でも使えます。</translation>
    </message>
    <message>
        <source>Guided tour on the simulated bridge</source>
        <translation>模擬ブリッジでのガイドツアー</translation>
    </message>
    <message>
        <source>Connects, records three runs faster than time, trains, compares and writes the table. Under two minutes, no hardware.</source>
        <translation>接続し、3 回の測定を実時間より速く記録して、学習、比較、テーブルの書き込みまで行います。2 分以内、ハードウェア不要です。</translation>
    </message>
    <message>
        <source>Connect a bridge</source>
        <translation>ブリッジを接続</translation>
    </message>
    <message>
        <source>A native gyro bridge, or an L3GD20H or I3G4250D behind a USB-to-I2C chip.</source>
        <translation>専用ジャイロブリッジ、または USB–I2C チップ経由の L3GD20H か I3G4250D。</translation>
    </message>
    <message>
        <source>Open log files or a session…</source>
        <translation>ログファイルまたはセッションを開く…</translation>
    </message>
    <message>
        <source>CSV, PX4 ULog, ArduPilot DataFlash. The format is found by content.</source>
        <translation>CSV、PX4 ULog、ArduPilot DataFlash。形式は内容から判別します。</translation>
    </message>
    <message>
        <source>Files can also be dropped anywhere on this window. F1 lists all keys.</source>
        <translation>ファイルはこのウィンドウのどこにでもドロップできます。F1 ですべてのキーを一覧表示します。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>スタート</translation>
    </message>
</context>
<context>
    <name>driftbench::StepRail</name>
    <message>
        <source>done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>警告あり</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>記録中</translation>
    </message>
    <message>
        <source>working</source>
        <translation>処理中</translation>
    </message>
    <message>
        <source>%1 (Alt+%2)</source>
        <translation>%1 (Alt+%2)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>ステップ</translation>
    </message>
</context>
<context>
    <name>driftbench::StripView</name>
    <message>
        <source>The last minute of the source</source>
        <translation>ソースの直近 1 分間</translation>
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
        <translation>受信なし</translation>
    </message>
    <message>
        <source>Choose a source at the left.</source>
        <translation>左でソースを選択してください。</translation>
    </message>
    <message>
        <source>Time before now (s)</source>
        <translation>現在までの時間 (s)</translation>
    </message>
</context>
<context>
    <name>driftbench::TableDifferenceView</name>
    <message>
        <source>New table less the one on the device</source>
        <translation>新テーブルとデバイスのテーブルの差</translation>
    </message>
    <message>
        <source>Nothing to compare</source>
        <translation>比較対象なし</translation>
    </message>
    <message>
        <source>No table is on the device.</source>
        <translation>デバイスにテーブルがありません。</translation>
    </message>
    <message>
        <source>New − now (mdps)</source>
        <translation>新 − 現在 (mdps)</translation>
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
        <translation>各セルでのテーブルの最大誤差</translation>
    </message>
    <message>
        <source>Worst in each cell</source>
        <translation>各セルの最大値</translation>
    </message>
    <message>
        <source>worst %1 mdps</source>
        <translation>最大 %1 mdps</translation>
    </message>
    <message>
        <source>no table</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>No table yet</source>
        <translation>テーブルなし</translation>
    </message>
    <message>
        <source>Train a model to see what a table of it costs.</source>
        <translation>モデルを学習すると、テーブル化による誤差が分かります。</translation>
    </message>
    <message>
        <source>Table against model</source>
        <translation>テーブル対モデル</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>Error (mdps)</source>
        <translation>誤差 (mdps)</translation>
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
        <translation>温度量に対するドリフト誤差</translation>
    </message>
    <message>
        <source>Excluded</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>昇温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>降温</translation>
    </message>
    <message>
        <source>Fitted curve, %1, with its 95 % band</source>
        <translation>近似曲線、%1、95 % 帯付き</translation>
    </message>
    <message>
        <source>Fitted curve, %1</source>
        <translation>近似曲線、%1</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>選択中</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>サンプルなし</translation>
    </message>
    <message>
        <source>All samples are excluded, or no run was given.</source>
        <translation>全サンプルが除外されているか、測定が指定されていません。</translation>
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
        <translation>TDE、%1 (dps)</translation>
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
        <translation>温度量とドリフト誤差の時系列</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>測定を記録するか、ログファイルを開いてください。</translation>
    </message>
    <message>
        <source>Temperature quantity</source>
        <translation>温度量</translation>
    </message>
    <message>
        <source>TDE, mean and range</source>
        <translation>TDE、平均と範囲</translation>
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
        <translation>TDE、%1 (dps)</translation>
    </message>
    <message>
        <source>Time since start</source>
        <translation>経過時間</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainFigures</name>
    <message>
        <source>Trained. Judged once all are.</source>
        <translation>学習済み。全モデルの学習後に判定します。</translation>
    </message>
    <message>
        <source>Waiting.</source>
        <translation>待機中。</translation>
    </message>
    <message>
        <source>Training on each set of runs.</source>
        <translation>測定の各組で学習中。</translation>
    </message>
    <message>
        <source>Cancelled before it was finished.</source>
        <translation>完了前にキャンセルされました。</translation>
    </message>
</context>
<context>
    <name>driftbench::TrainOptions</name>
    <message>
        <source>Preset of the RBF network</source>
        <translation>RBF ネットワークのプリセット</translation>
    </message>
    <message>
        <source>inputs of the RBF network</source>
        <translation>RBF ネットワークの入力</translation>
    </message>
    <message>
        <source>Ridge</source>
        <translation>リッジ</translation>
    </message>
    <message>
        <source>Hidden units of the BP network</source>
        <translation>BP ネットワークの隠れユニット</translation>
    </message>
    <message>
        <source>Starts of the BP network</source>
        <translation>BP ネットワークの初期値</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>number of centres</source>
        <translation>中心数</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>ridge</source>
        <translation>リッジ</translation>
    </message>
    <message>
        <source>hidden units</source>
        <translation>隠れユニット</translation>
    </message>
    <message>
        <source>starts</source>
        <translation>初期値</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>hold-out</source>
        <translation>検証方法</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>判定方法</translation>
    </message>
    <message>
        <source>models</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>One run in turn</source>
        <translation>1 測定ずつ順に</translation>
    </message>
    <message>
        <source>Only %1</source>
        <translation>%1 のみ</translation>
    </message>
    <message>
        <source>Blocks of temperature</source>
        <translation>温度ブロック</translation>
    </message>
    <message>
        <source>Auto, up to %1</source>
        <translation>自動、最大 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n, for every axis</source>
        <translation>
            <numerusform>%n、全軸共通</numerusform>
        </translation>
    </message>
    <message>
        <source>Auto, %1 tried</source>
        <translation>自動、%1 通り試行</translation>
    </message>
    <message>
        <source>Absolute</source>
        <translation>絶対</translation>
    </message>
    <message>
        <source>Anchored</source>
        <translation>始点基準</translation>
    </message>
    <message>
        <source>Gaussians on the temperature quantities, placed by orthogonal least squares.</source>
        <translation>温度量上のガウス関数で、直交最小二乗法で配置します。</translation>
    </message>
    <message>
        <source>A network with tanh units, trained from several seeded starts.</source>
        <translation>tanh ユニットのネットワークで、シードで決まる複数の初期値から学習します。</translation>
    </message>
    <message>
        <source>As PX4 fits it: medians, 2 000 bins of temperature, a cubic.</source>
        <translation>PX4 の当てはめ方：中央値、2 000 の温度ビン、3 次式。</translation>
    </message>
    <message>
        <source>As ArduPilot fits it: means of 2 s, a cubic about 35 °C.</source>
        <translation>ArduPilot の当てはめ方：2 s 平均、35 °C を中心とする 3 次式。</translation>
    </message>
    <message>
        <source>Least squares on ΔT.</source>
        <translation>ΔT の最小二乗法です。</translation>
    </message>
    <message>
        <source>Always in: the others can&apos;t tell every temperature from every other.</source>
        <translation>常に使用します。他の入力だけではすべての温度を区別できません。</translation>
    </message>
    <message>
        <source>The rate of the temperature is an experiment: it did not survive on recorded runs held out, and no table could hold it. driftbench-cli fit --dynamic measures it.</source>
        <translation>温度変化率は実験的です。実測した検証用の測定では効果がなく、テーブルにも格納できません。driftbench-cli fit --dynamic で評価できます。</translation>
    </message>
    <message>
        <source>Auto: the smallest number that does as well as the best on runs left out.</source>
        <translation>自動：検証用の測定で最良と同等の結果になる最小の数です。</translation>
    </message>
    <message>
        <source>Widths of the Gaussians, each half the one before, from the whole span down.</source>
        <translation>ガウス関数の幅です。全スパンから始めて順に半分にします。</translation>
    </message>
    <message>
        <source>How many samples&apos; worth of doubt shrinks each Gaussian. More is smoother.</source>
        <translation>各ガウス関数を縮小する不確かさを、サンプル数換算で表します。大きいほど滑らかです。</translation>
    </message>
    <message>
        <source>Tanh units in the hidden layer of the BP network.</source>
        <translation>BP ネットワークの隠れ層の tanh ユニットです。</translation>
    </message>
    <message>
        <source>Seeded starts of the BP network; the best one counts.</source>
        <translation>BP ネットワークのシードで決まる初期値です。最良のものを採用します。</translation>
    </message>
    <message>
        <source>Same runs, options and seed: the same models, bit for bit.</source>
        <translation>測定、オプション、シードが同じなら、モデルはビット単位で一致します。</translation>
    </message>
    <message>
        <source>Which runs are judged by models that have not seen them.</source>
        <translation>学習に使っていないモデルで判定する測定です。</translation>
    </message>
    <message>
        <source>Absolute: the turn-on bias counts, as in PX4. Anchored: the bias at the start of each run is removed, as ArduPilot does.</source>
        <translation>絶対：PX4 と同様に起動時バイアスを含めます。始点基準：ArduPilot と同様に各測定の開始時のバイアスを除去します。</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>RBF inputs</source>
        <translation>RBF 入力</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>オプション</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最良</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>論文</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>両方</translation>
    </message>
    <message>
        <source>RBF network</source>
        <translation>RBF ネットワーク</translation>
    </message>
    <message>
        <source>BP network</source>
        <translation>BP ネットワーク</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as PX4</source>
        <translation>ΔT の 3 次式、PX4 方式</translation>
    </message>
    <message>
        <source>Cubic in ΔT, as ArduPilot</source>
        <translation>ΔT の 3 次式、ArduPilot 方式</translation>
    </message>
    <message>
        <source>Line in ΔT</source>
        <translation>ΔT の直線</translation>
    </message>
    <message>
        <source>Centres</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Widths</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>BP units</source>
        <translation>BP ユニット</translation>
    </message>
    <message>
        <source>BP starts</source>
        <translation>BP 初期値</translation>
    </message>
    <message>
        <source>Hold out</source>
        <translation>検証方法</translation>
    </message>
    <message>
        <source>Judged</source>
        <translation>判定</translation>
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
        <translation>モデル</translation>
    </message>
    <message>
        <source>Progress of the training</source>
        <translation>学習の進捗</translation>
    </message>
    <message>
        <source>The training was refused.</source>
        <translation>学習が拒否されました。</translation>
    </message>
    <message>
        <source>The training can&apos;t start.</source>
        <translation>学習を開始できません。</translation>
    </message>
    <message numerus="yes">
        <source>take %n centres</source>
        <translation>
            <numerusform>中心数を %n に設定</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Each run is held out once.</source>
        <translation>各測定を 1 回ずつ検証に使います。</translation>
    </message>
    <message>
        <source>Shown is what was trained before the last change. Train again.</source>
        <translation>表示は最後の変更前の学習結果です。再学習してください。</translation>
    </message>
    <message>
        <source>Blocks of temperature are held out: one run can&apos;t show that another repeats it.</source>
        <translation>温度ブロックを検証に使います。1 測定だけでは再現性を示せません。</translation>
    </message>
    <message>
        <source>Each run is held out once. Held-out error counts, training error does not.</source>
        <translation>各測定を 1 回ずつ検証に使います。学習誤差ではなく検証誤差で評価します。</translation>
    </message>
    <message>
        <source>Train again</source>
        <translation>再学習</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>学習</translation>
    </message>
    <message>
        <source>Nothing to train on</source>
        <translation>学習対象なし</translation>
    </message>
    <message>
        <source>Record a run, or open a log file.</source>
        <translation>測定を記録するか、ログファイルを開いてください。</translation>
    </message>
    <message>
        <source>Not trained yet</source>
        <translation>未学習</translation>
    </message>
    <message>
        <source>Choose the models at the left and train them.</source>
        <translation>左でモデルを選択し、学習してください。</translation>
    </message>
    <message>
        <source>These runs can&apos;t be trained on.</source>
        <translation>これらの測定では学習できません。</translation>
    </message>
    <message>
        <source>Centres: the fewest that do as well as the best on runs left out. Here %1.</source>
        <translation>中心数：検証用の測定で最良と同等の結果になる最小の数です。ここでは %1 です。</translation>
    </message>
    <message>
        <source>Training, %1 %</source>
        <translation>学習中、%1 %</translation>
    </message>
    <message>
        <source>Changed, train again</source>
        <translation>変更あり、要再学習</translation>
    </message>
    <message numerus="yes">
        <source>%n model(s)</source>
        <translation>
            <numerusform>モデル %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Esc cancel. What is finished is kept.</source>
        <translation>Esc キャンセル。完了した分は保持されます。</translation>
    </message>
    <message>
        <source>Ctrl+R train · Click the curve of the excess to take that number of centres · F fit</source>
        <translation>Ctrl+R 学習 · 超過分の曲線をクリック その中心数に設定 · F 全体表示</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s), %1 samples</source>
        <translation>
            <numerusform>測定 %n 件、%1 サンプル</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Look at the runs</source>
        <translation>測定を見る</translation>
    </message>
    <message>
        <source>Train the chosen models and judge them on runs held out</source>
        <translation>選択したモデルを学習し、検証用の測定で判定します</translation>
    </message>
</context>
<context>
    <name>driftbench::TransientView</name>
    <message>
        <source>What is left of a step at the centre of the chamber, over time</source>
        <translation>恒温槽中心でのステップの残り、時系列</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 to ±%2 °C</source>
        <translation>±%2 °C まで %1</translation>
    </message>
    <message>
        <source>Nothing to settle</source>
        <translation>整定不要</translation>
    </message>
    <message>
        <source>The step is within what the thermometer can tell.</source>
        <translation>ステップは温度計の精度以内です。</translation>
    </message>
    <message>
        <source>Time after a step of %1 °C</source>
        <translation>%1 °C のステップ後の時間</translation>
    </message>
    <message>
        <source>Still to go (°C)</source>
        <translation>残り (°C)</translation>
    </message>
</context>
<context>
    <name>driftbench::UploadSteps</name>
    <message>
        <source>Begin</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>書き込み</translation>
    </message>
    <message>
        <source>Read back</source>
        <translation>読み戻し</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>照合</translation>
    </message>
    <message>
        <source>Commit</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>有効化</translation>
    </message>
    <message>
        <source>No upload under way</source>
        <translation>アップロードなし</translation>
    </message>
    <message>
        <source>Upload done</source>
        <translation>アップロード完了</translation>
    </message>
    <message>
        <source>Upload, step %1 of 6: %2</source>
        <translation>アップロード、ステップ %1/6：%2</translation>
    </message>
</context>
<context>
    <name>driftbench::VerdictCard</name>
    <message>
        <source>Write the table.</source>
        <translation>テーブルを書き込んでください。</translation>
    </message>
    <message>
        <source>Write only a constant, or the table with care.</source>
        <translation>定数のみを書き込むか、注意してテーブルを書き込んでください。</translation>
    </message>
    <message>
        <source>Write the table with care.</source>
        <translation>注意してテーブルを書き込んでください。</translation>
    </message>
    <message>
        <source>No table for %1.</source>
        <translation>%1 にはテーブルを使えません。</translation>
    </message>
    <message>
        <source>Nothing to write for %1: its bias does not move with temperature.</source>
        <translation>%1 に書き込むものはありません。バイアスは温度で変化しません。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>%1 times less than a constant</source>
        <translation>定数の 1/%1</translation>
    </message>
    <message>
        <source>%1 to %2 times less than a constant</source>
        <translation>定数の 1/%1～1/%2</translation>
    </message>
    <message>
        <source>It was not judged on any run.</source>
        <translation>どの測定でも判定されていません。</translation>
    </message>
    <message>
        <source>It leaves %1 dps rms</source>
        <translation>残留 %1 dps rms</translation>
    </message>
    <message>
        <source>With the %1 it leaves %2 dps rms</source>
        <translation>%1 での残留 %2 dps rms</translation>
    </message>
    <message>
        <source>, over the limit of %1</source>
        <translation>、許容値 %1 を超過</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>、%1</translation>
    </message>
    <message>
        <source>, a constant %1</source>
        <translation>、定数では %1</translation>
    </message>
    <message>
        <source>A constant does better on %1.</source>
        <translation>%1 では定数の方が優れています。</translation>
    </message>
    <message>
        <source>The rest is hysteresis, %1 times the noise.</source>
        <translation>残りはヒステリシスで、ノイズの %1 倍です。</translation>
    </message>
    <message>
        <source>Verdict for %1: %2. %3</source>
        <translation>%1 の判定：%2。%3</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>可</translation>
    </message>
    <message>
        <source>With care</source>
        <translation>要注意</translation>
    </message>
    <message>
        <source>No</source>
        <translation>不可</translation>
    </message>
    <message>
        <source>No drift</source>
        <translation>ドリフトなし</translation>
    </message>
    <message numerus="yes">
        <source>fails on %1 of %n runs</source>
        <translation>
            <numerusform>%n 測定中 %1 で不合格</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>passes on %1 of %n runs</source>
        <translation>
            <numerusform>%n 測定中 %1 で合格</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>driftbench::Workbench</name>
    <message>
        <source>Simulated bridge</source>
        <translation>模擬ブリッジ</translation>
    </message>
    <message>
        <source>Gyro bridge</source>
        <translation>ジャイロブリッジ</translation>
    </message>
</context>
</TS>
