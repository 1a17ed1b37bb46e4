# The table as one page without scripts: a chart of error against time and all rows for each scene and size.
function escaped(text) {
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    gsub(/"/, "\\&quot;", text)
    return text
}
function log_of(number) {
    return log(number) / log(10)
}
# Marks 1, 2, 5, 10 ... of an axis from `low` to `high`.
function mark_below(number,    power, digit) {
    power = exp(log(10) * (int(log_of(number) + 1000) - 1000))
    digit = number / power
    return power * (digit >= 4.999 ? 5 : digit >= 1.999 ? 2 : 1)
}
function mark_after(mark,    digit) {
    digit = mark / exp(log(10) * (int(log_of(mark) + 1000.0001) - 1000))
    return mark * (digit < 1.5 ? 2 : digit < 3 ? 2.5 : 2)
}
function x_of(number) { return 64 + 500 * (log_of(number) - log_of(x_low)) / (log_of(x_high) - log_of(x_low)) }
function y_of(number) { return 330 - 310 * (log_of(number) - log_of(y_low)) / (log_of(y_high) - log_of(y_low)) }
function print_axes(    mark) {
    for (mark = x_low; mark <= x_high * 1.001; mark = mark_after(mark))
        printf "<path class=\"grid\" d=\"M%.1f 20V330\"/><text class=\"tick\" x=\"%.1f\" y=\"350\" text-anchor=\"middle\">%.6g</text>\n",
            x_of(mark), x_of(mark), mark
    for (mark = y_low; mark <= y_high * 1.001; mark = mark_after(mark))
        printf "<path class=\"grid\" d=\"M64 %.1fH564\"/><text class=\"tick\" x=\"58\" y=\"%.1f\" text-anchor=\"end\">%.6g</text>\n",
            y_of(mark), y_of(mark) + 4, mark
    print "<text x=\"314\" y=\"372\" text-anchor=\"middle\">CPU ms of a frame</text>"
    print "<text transform=\"translate(16 175) rotate(-90)\" text-anchor=\"middle\">relative RMSE of indirect light, %</text>"
}
# Names stand in a column on the right, none over another.
function print_points(count,    i, j, row, y, low, label) {
    for (i = 2; i <= count; i++) {
        row = points[i]
        for (j = i - 1; j > 0 && error_of(points[j]) < error_of(row); j--)
            points[j + 1] = points[j]
        points[j + 1] = row
    }
    low = 12
    for (i = 1; i <= count; i++) {
        y = y_of(error_of(points[i]))
        low = label[i] = y > low + 16 ? y : low + 16
    }
    for (i = count; i > 0; i--) {
        y = i < count ? label[i + 1] - 16 : 320
        if (label[i] > y)
            label[i] = y
    }
    for (i = 1; i <= count; i++) {
        row = points[i]
        printf "<g class=\"point\"><path d=\"M%.1f %.1fL574 %.1f\"/><circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\"><title>%s: %s ms, %.4g %%</title></circle><text x=\"578\" y=\"%.1f\">%s</text></g>\n",
            x_of(time_of(row)), y_of(error_of(row)), label[i], x_of(time_of(row)), y_of(error_of(row)),
            escaped(text[row, "method"]), whole(time_of(row)), error_of(row), label[i] + 4, escaped(short_name(text[row, "method"]))
    }
}
# As much of a name as stands beside the chart; the whole is in the point's title and in the table.
function short_name(name) { return length(name) > 24 ? substr(name, 1, 21) "..." : name }
function time_of(row) { return (value[row, "cpu"] != "" ? value[row, "cpu"] : value[row, "ms"]) + 0 }
function error_of(row) { return 100 * value[row, "indirect-relative-rmse"] }
function print_chart(list, count, name,    i, row, shown_count) {
    x_low = y_low = 1e30
    x_high = y_high = 0
    for (i = 1; i <= count; i++) {
        row = list[i]
        if (!(time_of(row) > 0 && error_of(row) > 0))
            continue
        points[++shown_count] = row
        if (time_of(row) < x_low) x_low = time_of(row)
        if (time_of(row) > x_high) x_high = time_of(row)
        if (error_of(row) < y_low) y_low = error_of(row)
        if (error_of(row) > y_high) y_high = error_of(row)
    }
    if (!shown_count)
        return
    x_low = mark_below(x_low * .95)
    y_low = mark_below(y_low * .95)
    x_high = mark_after(mark_below(x_high * 1.02))
    y_high = mark_after(mark_below(y_high * 1.02))
    printf "<svg viewBox=\"0 0 760 380\" role=\"img\" aria-label=\"%s: error against time\">\n", escaped(name)
    print_axes()
    print_points(shown_count)
    print "</svg>"
}
function cell(content) { printf "<td>%s</td>", content }
function print_row(row) {
    printf "<tr><td>%s</td>", escaped(text[row, "method"])
    if (text[row, "status"] != "ok") {
        printf "<td colspan=\"8\" class=\"note\">failed: %s</td></tr>\n", escaped(text[row, "error"])
        return
    }
    cell(shown(value[row, "indirect-relative-rmse"], 3, 100))
    cell(shown(value[row, "relative-rmse"], 3, 100))
    cell(shown(value[row, "hdr-flip"], 2))
    cell(shown(value[row, "indirect-relative-bias"], 2, 100))
    cell(whole(value[row, "ms"]))
    cell(whole(value[row, "cpu"]))
    cell(whole(value[row, "memory"]))
    printf "<td class=\"note\">%s</td></tr>\n", escaped(text[row, "faults"])
}
function print_case(scene, size, device,    i, row, count, list, noise) {
    for (i = 1; i <= method_count; i++) {
        row = row_of[scene, size, methods[i], device]
        if (row)
            list[++count] = row
        if (row && value[row, "noise"] != "")
            noise = value[row, "noise"]
    }
    if (!count)
        return
    printf "<h3>%s, %s</h3>\n", escaped(scene), escaped(size)
    printf "<p class=\"soft\">%s%s</p>\n", escaped(device), noise != "" ? "; noise of the reference " shown(noise, 2, 100) " %" : ""
    print_chart(list, count, scene " " size)
    print "<div class=\"wide\"><table><tr><th>method</th><th>indirect, %</th><th>beauty, %</th><th>FLIP</th><th>bias, %</th><th>ms</th><th>CPU ms</th><th>GPU MiB</th><th class=\"note\">faults</th></tr>"
    for (i = 1; i <= count; i++)
        print_row(list[i])
    print "</table></div>"
}
function print_head() {
    print "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">"
    print "<title>Error against time</title><style>"
    print ":root{color-scheme:light dark;--back:#fff;--text:#1a1a1a;--soft:#5a5a5a;--line:#d4d4d4;--mark:#b3411e}"
    print "@media(prefers-color-scheme:dark){:root{--back:#16181b;--text:#e6e6e6;--soft:#a3a3a3;--line:#3a3d42;--mark:#ff9a73}}"
    print "body{background:var(--back);color:var(--text);font:16px/1.5 system-ui,sans-serif;margin:0 auto;max-width:60rem;padding:1rem 1.25rem 3rem}"
    print "h1,h2,h3{line-height:1.2}h2,h3{margin-top:2.5rem}a{color:var(--mark)}.wide{overflow-x:auto}"
    print "table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}"
    print "th,td{padding:.25rem .5rem;border-bottom:1px solid var(--line);text-align:right;white-space:nowrap}"
    print "th:first-child,td:first-child,.note{text-align:left}td.note{white-space:normal;overflow-wrap:anywhere}"
    print ".soft,.tick{color:var(--soft);fill:var(--soft)}svg{width:100%;height:auto;font:13px system-ui,sans-serif;fill:var(--text)}"
    print ".grid{stroke:var(--line);fill:none}.point circle{fill:var(--mark)}.point path{stroke:var(--line);fill:none}.point:hover path{stroke:var(--mark)}"
    print "nav{columns:12rem}nav a{display:block}"
    print "</style></head><body>"
}
function anchor(scene) {
    gsub(/[^A-Za-z0-9]+/, "-", scene)
    return scene
}
END {
    sort_sizes()
    print_head()
    print "<h1>Error against time</h1>"
    print "<p>Methods of indirect light against a path-traced reference with as many bounces. Relative RMSE of indirect light and of the picture (beauty), FLIP, bias of the mean; the noise of the reference is part of each error. Times are medians of frames.</p>"
    printf "<p>Scenes: %d, methods: %d, cases: %d, failed: %d, with faults: %d; %s. <a href=\"results.json\">Results</a>, <a href=\"times.json\">times</a>, <a href=\"jeri.json\">list of pictures</a>.</p>\n",
        scene_count, method_count, rows, failed, faulty, escaped(commits_shown())
    print "<nav>"
    for (i = 1; i <= scene_count; i++)
        printf "<a href=\"#%s\">%s</a>\n", anchor(scenes[i]), escaped(scenes[i])
    print "</nav>"
    for (i = 1; i <= scene_count; i++) {
        printf "<section id=\"%s\"><h2>%s</h2>\n", anchor(scenes[i]), escaped(scenes[i])
        for (j = 1; j <= size_count; j++)
            for (k = 1; k <= device_count; k++)
                print_case(scenes[i], sizes[j], devices[k])
        print "</section>"
    }
    print "</body></html>"
}
