# The table as a page of bench/: for each machine and size the methods, then which method suits which scene.

# A name in a table, whose columns | parts.
function cell(name) {
    gsub(/[|]/, "\\\\&", name)
    return name
}
function cells(list, what, device, size, method,    i, row, count) {
    split("", list)
    for (i = 1; i <= scene_count; i++) {
        row = row_of[scenes[i], size, method, device]
        if (row && value[row, what] != "")
            list[++count] = value[row, what] < 0 ? -value[row, what] : value[row, what] + 0
    }
    return count + 0
}
function print_methods(device, size,    i, j, row, done, broken, faults, list, line) {
    print "| method | scenes | failed | with faults | indirect, % | beauty, % | FLIP | bias, % | ms | CPU ms |"
    print "|---|---|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= method_count; i++) {
        done = broken = faults = 0
        for (j = 1; j <= scene_count; j++) {
            row = row_of[scenes[j], size, methods[i], device]
            if (!row)
                continue
            done++
            broken += text[row, "status"] != "ok"
            faults += text[row, "faults"] != ""
        }
        if (!done)
            continue
        line = "| " cell(methods[i]) " | " done " | " (broken ? broken : "") " | " (faults ? faults : "")
        line = line " | " shown(median_of(list, cells(list, "indirect-relative-rmse", device, size, methods[i])), 3, 100)
        line = line " | " shown(median_of(list, cells(list, "relative-rmse", device, size, methods[i])), 3, 100)
        line = line " | " shown(median_of(list, cells(list, "hdr-flip", device, size, methods[i])), 2)
        line = line " | " shown(median_of(list, cells(list, "indirect-relative-bias", device, size, methods[i])), 2, 100)
        line = line " | " whole(median_of(list, cells(list, "ms", device, size, methods[i])))
        print line " | " whole(median_of(list, cells(list, "cpu", device, size, methods[i]))) " |"
    }
}
# The row of a scene with the least of a field, among errors up to a limit; 0 where there is none.
function least(scene, size, device, what, limit,    i, row, best, error) {
    for (i = 1; i <= method_count; i++) {
        row = row_of[scene, size, methods[i], device]
        error = row ? value[row, "indirect-relative-rmse"] : ""
        if (error == "" || error + 0 > limit || value[row, what] == "")
            continue
        if (!best || value[row, what] + 0 < value[best, what] + 0)
            best = row
    }
    return best + 0
}
function noise_of(scene, size, device,    i, row) {
    for (i = 1; i <= method_count; i++) {
        row = row_of[scene, size, methods[i], device]
        if (row && value[row, "noise"] != "")
            return value[row, "noise"]
    }
    return ""
}
function told(row) {
    return row ? " | " cell(text[row, "method"]) " | " shown(value[row, "indirect-relative-rmse"], 3, 100) " | " whole(value[row, "cpu"]) : " | | |"
}
# Whether a method has a layer of indirect light.
function has_indirect(device, size,    i, list) {
    for (i = 1; i <= method_count; i++)
        if (cells(list, "indirect-relative-rmse", device, size, methods[i]))
            return 1
    return 0
}
function print_scenes(device, size,    i, noise, best, left_out) {
    if (!has_indirect(device, size))
        return
    print ""
    print "| scene | noise, % | least error | % | CPU ms | fastest within 10 % | % | CPU ms | fastest within 25 % | % | CPU ms |"
    print "|---|---|---|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= scene_count; i++) {
        noise = noise_of(scenes[i], size, device)
        best = least(scenes[i], size, device, "indirect-relative-rmse", 1e30)
        if (noise == "")
            continue
        if (best)
            print "| `" cell(scenes[i]) "` | " shown(noise, 2, 100) told(best) \
                told(least(scenes[i], size, device, "cpu", .1)) told(least(scenes[i], size, device, "cpu", .25)) " |"
        else
            left_out = left_out (left_out ? ", " : "") "`" cell(scenes[i]) "`"
    }
    if (left_out)
        print "\nToo much noise in the reference for a row: " left_out "."
}
# Other renderers have no settings; most have no layer of indirect light.
function print_others(device, size,    i, j, row, n) {
    for (i = 1; i <= scene_count; i++)
        for (j = 1; j <= method_count; j++) {
            row = row_of[scenes[i], size, methods[j], device]
            if (!row || text[row, "status"] != "ok" || text[row, "settings"] != "")
                continue
            if (!n++) {
                print "\n| scene | other renderer | beauty, % | bias, % | FLIP | ms |"
                print "|---|---|---|---|---|---|"
            }
            print "| `" cell(scenes[i]) "` | " cell(methods[j]) " | " shown(value[row, "relative-rmse"], 3, 100) " | " \
                shown(value[row, "relative-bias"], 2, 100) " | " shown(value[row, "hdr-flip"], 2) " | " whole(value[row, "ms"]) " |"
        }
}
function print_failures(    i, n, head) {
    for (i = 1; i <= rows; i++)
        if (text[i, "status"] != "ok") {
            if (!n++)
                print "\n## Failed cases\n"
            head = "- `" text[i, "scene"] "` " text[i, "size"] " " text[i, "method"] ":"
            print head (length(head text[i, "error"]) > 117 ? "\n  `" : " `") text[i, "error"] "`"
        }
}
END {
    sort_sizes()
    print "# Table of error against time\n"
    print "This page compares methods by their error against a path-traced reference with as many bounces, and by the time of"
    print "a frame. `make table` writes it. [Benchmarking](../docs/dev/benchmarking.md#the-table) tells how, and how to enter"
    print "another renderer.\n"
    print "- Errors: relative RMSE of indirect light and of the picture; FLIP; absolute bias of indirect light. Medians of scenes."
    print "- The picture has direct light too. Edges of spots' cones and shadows, not antialiased, lead its error in small"
    print "  pictures."
    print "- Times: medians of frames; of other renderers their own. On software OpenGL two scenes are measured at once, so that"
    print "  the clock tells little: compare CPU times."
    print "- Noise: standard error of the reference over its mean. It is part of each error: subtract it as squares."
    print "- Relative errors of indirect light need a reference with indirect light and at most 25 % noise."
    print "- Cycles in the same time as manylight: [halls](../docs/notes/outsiders.md) of 1,000 lights and 10 million triangles."
    printf "- Scenes: %d, methods: %d, cases: %d, failed: %d, with faults: %d; %s.\n", scene_count, method_count,
        rows, failed, faulty, commits_shown()
    for (i = 1; i <= device_count; i++)
        for (j = 1; j <= size_count; j++) {
            printf "\n## %s, %s\n\n", sizes[j], devices[i]
            print_methods(devices[i], sizes[j])
            print_scenes(devices[i], sizes[j])
            print_others(devices[i], sizes[j])
        }
    print_failures()
}
