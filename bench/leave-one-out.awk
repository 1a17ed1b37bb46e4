# Leave one out, from what `manylight bench quality --csv FILE` wrote of several scenes: a ladder that knows nothing of a scene,
# judged on it, as a table in Markdown:
#
#     awk -f bench/leave-one-out.awk FILE.csv
#
# A ladder has what is on the front of error against CPU time, but for a twentieth of the time, in half of the scenes that it
# is made from; cheapest first, by the mean of the logarithms of times. On a scene it takes the first choice that errs no more than
# asked for, or else the cheapest of those that nothing errs less than by a tenth, by measured errors. A cell tells
# its CPU time over that of the fastest of all choices that errs no more; in brackets where it errs more than was asked
# for; "missed" where another choice of that scene reaches it. First without the scene in the ladder, then with it.

BEGIN {
    FS = ","
    askeds = split("2 4 8 16 30", asked, " ")
}

function unquoted(text) {
    gsub(/"/, "", text)
    return text
}

FNR > 1 && ($7 == "ladder" || $7 == "fixed") && ($10 == "error" || $10 == "cpu") {
    scene = unquoted($2)
    choice = unquoted($8)
    if (!(scene in scene_known)) { scene_known[scene]; scenes[++scene_count] = scene }
    if (!(choice in choice_known)) { choice_known[choice]; choices[++choice_count] = choice }
    if ($10 == "error") error[scene, choice] = $13
    else cpu[scene, choice] = $13
}

function has(scene, choice) { return (scene, choice) in cpu }

function on_front(scene, choice,   i) {
    for (i = 1; i <= choice_count; i++)
        if (has(scene, choices[i]) && error[scene, choices[i]] <= error[scene, choice] &&
            cpu[scene, choices[i]] * 1.05 < cpu[scene, choice])
            return 0
    return 1
}

# Into ladder[1..n], which it returns; without = a scene, or "".
function make_ladder(without,   i, k, n, of, fronts, sum, mean, c) {
    n = 0
    for (i = 1; i <= choice_count; i++) {
        of = fronts = sum = 0
        c = choices[i]
        for (k = 1; k <= scene_count; k++)
            if (scenes[k] != without && has(scenes[k], c)) {
                of++
                fronts += on_front(scenes[k], c)
                sum += log(cpu[scenes[k], c] / cpu[scenes[k], "path=draft"])
            }
        if (of == 0 || fronts * 2 < of)
            continue
        mean = sum / of
        for (k = n++; k > 0 && means[k] > mean; k--) {
            means[k + 1] = means[k]
            ladder[k + 1] = ladder[k]
        }
        means[k + 1] = mean
        ladder[k + 1] = c
    }
    return n
}

function take(scene, n, error_asked,   i, least) {
    least = 1e9
    for (i = 1; i <= n; i++)
        if (has(scene, ladder[i])) {
            if (error[scene, ladder[i]] <= error_asked)
                return ladder[i]
            if (error[scene, ladder[i]] < least)
                least = error[scene, ladder[i]]
        }
    for (i = 1; i <= n; i++)
        if (has(scene, ladder[i]) && error[scene, ladder[i]] * .9 <= least)
            return ladder[i]
}

function fastest(scene, error_most,   i, least) {
    least = 1e9
    for (i = 1; i <= choice_count; i++)
        if (has(scene, choices[i]) && error[scene, choices[i]] <= error_most && cpu[scene, choices[i]] < least)
            least = cpu[scene, choices[i]]
    return least
}

function cell(scene, n, error_asked,   taken, ratio) {
    taken = take(scene, n, error_asked)
    ratio = sprintf("%.2f", cpu[scene, taken] / fastest(scene, error[scene, taken]))
    if (error[scene, taken] <= error_asked)
        return ratio
    return fastest(scene, error_asked) < 1e9 ? "missed" : "(" ratio ")"
}

function cells(scene, without,   i, n, line) {
    n = make_ladder(without)
    if (n == 0)
        return "nothing to learn from"
    for (i = 1; i <= askeds; i++)
        line = line (i > 1 ? ", " : "") cell(scene, n, asked[i])
    return line
}

END {
    print "| left out | without it: 2, 4, 8, 16, 30 % | with it |"
    print "|---|---|---|"
    for (s = 1; s <= scene_count; s++)
        printf "| %s | %s | %s |\n", scenes[s], cells(scenes[s], scenes[s]), cells(scenes[s], "")
}
