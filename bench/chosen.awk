# What --max-error chose, from what `manylight bench quality --csv FILE` wrote of several scenes, as a table in Markdown:
#
#     awk -f bench/chosen.awk FILE.csv
#
# A cell: the estimated error, the measured one, and the CPU time over that of the fastest choice that errs no more; in
# brackets where no choice of that scene has the error asked for. Below it, how far off that is at most, and how near errors
# of all choices are estimated. Scenes without indirect light, whose errors are infinite or nothing, have no row.

BEGIN {
    FS = ","
    askeds = split("2 4 8 16 30", asked, " ")
}

function unquoted(text) {
    gsub(/"/, "", text)
    return text
}

FNR > 1 {
    scene = unquoted($2)
    subject = scene SUBSEP $7 SUBSEP unquoted($8)
    if ($7 == "automatic") {
        if (!(scene in known)) { known[scene]; scenes[++count] = scene }
        value[scene, unquoted($8), $10] = $13
    } else if ($10 == "error") {
        error[subject] = $13
        if ($13 ~ /^[0-9]/ && $13 > 0)
            lit[scene]
        if ($7 != "0 fov=.4" && (!(scene in least) || $13 < least[scene]))
            least[scene] = $13
    } else if ($10 == "told") {
        estimated[subject] = $13
    }
}

function cell(scene, asked,   point, text, of) {
    point = "error=" asked "%"
    of = value[scene, point, "of-fastest"]
    text = sprintf("%.1f, %.1f, %.2f", value[scene, point, "told"], value[scene, point, "error"], of)
    if (of > dearest) { dearest = of; dearest_at = scene " at " asked " %" }
    if (least[scene] > asked)
        return "(" text ")"
    points++
    if (value[scene, point, "of-asked"] > 1.2) { over = over "; " scene " at " asked " %: " value[scene, point, "of-asked"] }
    if (value[scene, point, "of-asked"] > worst) { worst = value[scene, point, "of-asked"]; worst_at = scene " at " asked " %" }
    return text
}

END {
    print "| estimated %, error %, time of the fastest's | 2 % | 4 % | 8 % | 16 % | 30 % |"
    print "|---|---|---|---|---|---|"
    for (s = 1; s <= count; s++) {
        if (!(scenes[s] in lit))
            continue
        lit_scenes++
        line = "| " scenes[s]
        for (i = 1; i <= askeds; i++)
            line = line " | " cell(scenes[s], asked[i])
        print line " |"
    }
    printf "\nOf %d points %d can be had; time at most %.2f of the fastest's (%s), error at most %.2f of what was asked for (%s)%s\n", \
        lit_scenes * askeds, points, dearest, dearest_at, worst, worst_at, over
    for (t in estimated) {
        if (error[t] !~ /^[0-9]/ || error[t] <= 0)
            continue
        rows++
        ratio = estimated[t] / error[t]
        off = ratio > 1 ? ratio : 1 / ratio
        tenth += off <= 1.1
        fifth += off <= 1.2
        if (off > furthest) { furthest = off; split(t, names, SUBSEP); furthest_at = sprintf("%s, %s: %.1f for %.1f %%", names[1], names[3], estimated[t], error[t]) }
    }
    printf "Of %d estimated errors %d are within a tenth, %d within a fifth; furthest off: %s\n\n", rows, tenth, fifth, furthest_at
}
