# Reads times.json, then results.json: scripts that follow write a page of the rows in END.
#
# Each row is a line. Rows are numbered from 1 to `rows`; their fields are text[row, field] and value[row, field], where
# a number that is missing is "". Scenes, sizes and methods are listed in the order in which they come.
function field(line, name,    at, rest) {
    at = index(line, "\"" name "\": ")
    if (!at)
        return ""
    rest = substr(line, at + length(name) + 4)
    if (substr(rest, 1, 1) == "\"") {
        match(rest, /^"([^"\\]|\\.)*"/)
        rest = substr(rest, 2, RLENGTH - 2)
        gsub(/\\"/, "\"", rest)
        gsub(/\\\\/, "\\", rest)
        return rest
    }
    match(rest, /^[^,}\]]*/)
    rest = substr(rest, 1, RLENGTH)
    return rest == "null" ? "" : rest
}
# The part of a row that scores a layer.
function layer_of(line, layer,    at) {
    at = index(line, "\"layer\": \"" layer "\"")
    if (!at)
        return ""
    line = substr(line, at)
    at = index(line, "{\"picture\":")
    return at ? substr(line, 1, at - 1) : line
}
function faults_of(part,    list, name) {
    while (match(part, /"fault": "[^"]*"/)) {
        name = substr(part, RSTART + 10, RLENGTH - 11)
        list = list (list == "" ? "" : " ") name
        part = substr(part, RSTART + RLENGTH)
    }
    return list
}
function list_once(list, count, item,    i) {
    for (i = 1; i <= count; i++)
        if (list[i] == item)
            return count
    list[count + 1] = item
    return count + 1
}
function key_of(line) {
    return field(line, "scene") SUBSEP field(line, "size") SUBSEP field(line, "method") SUBSEP field(line, "device")
}
function commits_shown(    i, all) {
    for (i = 1; i <= commit_count; i++)
        all = all (i > 1 ? ", " : "") commits[i]
    return (commit_count > 1 ? "commits " : "commit ") all
}
# Sorts a list of numbers; few, so by insertion.
function sort_numbers(list, count,    i, j, item) {
    for (i = 2; i <= count; i++) {
        item = list[i]
        for (j = i - 1; j > 0 && list[j] > item; j--)
            list[j + 1] = list[j]
        list[j + 1] = item
    }
}
function median_of(list, count) {
    sort_numbers(list, count)
    return count == 0 ? "" : count % 2 ? list[(count + 1) / 2] : (list[count / 2] + list[count / 2 + 1]) / 2
}
# Number with so many digits, percent where the factor is 100; nothing where there is none.
function shown(number, digits, factor) {
    if (number == "")
        return ""
    return sprintf("%." digits "g", number * (factor ? factor : 1))
}
function whole(number) {
    return number == "" ? "" : number < 100 ? sprintf("%.2g", number) : sprintf("%d", number + .5)
}
# Small sizes first.
function sort_sizes(    i, j, item) {
    for (i = 2; i <= size_count; i++) {
        item = sizes[i]
        for (j = i - 1; j > 0 && sizes[j] + 0 > item + 0; j--)
            sizes[j + 1] = sizes[j]
        sizes[j + 1] = item
    }
}
function take_scores(line,    part, indirect, names, i, n) {
    part = layer_of(line, "beauty")
    indirect = layer_of(line, "indirect")
    n = split("relative-rmse mrse smape hdr-flip relative-bias", names, " ")
    for (i = 1; i <= n; i++) {
        value[rows, names[i]] = field(part, names[i])
        value[rows, "indirect-" names[i]] = indirect == "" ? "" : field(indirect, names[i])
    }
    value[rows, "noise"] = field(part, "noise")
    # A reference of more noise tells no relative error: specular light in dark places.
    if (value[rows, "noise"] + 0 > .25)
        value[rows, "indirect-relative-rmse"] = ""
    text[rows, "faults"] = faults_of(part indirect)
}
/^{"rows"/ || /^\]/ { next }
NR == FNR {
    times[key_of($0)] = $0
    next
}
{
    rows++
    text[rows, "scene"] = field($0, "scene")
    text[rows, "size"] = field($0, "size")
    text[rows, "method"] = field($0, "method")
    text[rows, "device"] = field($0, "device")
    text[rows, "commit"] = field($0, "commit")
    text[rows, "settings"] = field($0, "settings")
    text[rows, "status"] = field($0, "status")
    text[rows, "error"] = field($0, "error")
    take_scores(substr($0, index($0, "\"scores\": ")))
    time = times[key_of($0)]
    value[rows, "ms"] = field(time, "ms")
    value[rows, "cpu"] = field(time, "cpu_ms")
    value[rows, "memory"] = field(time, "gpu_mib")
    failed += text[rows, "status"] != "ok"
    faulty += text[rows, "faults"] != ""
    row_of[text[rows, "scene"], text[rows, "size"], text[rows, "method"], text[rows, "device"]] = rows
    scene_count = list_once(scenes, scene_count, text[rows, "scene"])
    size_count = list_once(sizes, size_count, text[rows, "size"])
    method_count = list_once(methods, method_count, text[rows, "method"])
    device_count = list_once(devices, device_count, text[rows, "device"])
    commit_count = list_once(commits, commit_count, text[rows, "commit"])
}
