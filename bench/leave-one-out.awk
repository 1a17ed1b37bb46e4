# Leave one out, from what `manylight bench quality --csv FILE` wrote of several scenes: a ladder that knows nothing of a scene,
# judged on it, as a table in Markdown:
#
#     awk -f bench/leave-one-out.awk FILE.csv
#
# A ladder is learnt from scenes: all choices that are on the front of error against CPU time in any of them (but for a twentieth
# of the time; unshadowed is none, as it is wrong wherever something hides light), cheapest first by the mean of the logarithms of times; then each, those of the fewest fronts first, is left out
# where these scenes lose nothing by that, over all errors that may be asked for. On a scene it takes the first choice that errs
# no more than asked for, or else the cheapest of those that nothing errs less than by a tenth, by measured errors. A cell tells
# its CPU time over that of the fastest of all choices that errs no more; in brackets where it errs more than was asked
# for; "missed" where another choice of that scene reaches it. First learnt without the scene, then with it. A scene without
# indirect light, whose errors are infinite or nothing, has no part.

BEGIN {
    FS = ","
    askeds = split("2 4 8 16 30", asked, " ")
    for (a = 2; a < 41; a *= 2 ^ .25)
        learnt_asked[++learnt_askeds] = a
    miss = log(4) # costs as much as four times the time
}

function unquoted(text) {
    gsub(/"/, "", text)
    return text
}

FNR > 1 && ($7 == "ladder" || $7 == "fixed") && ($10 == "error" || $10 == "cpu") && $13 ~ /^[0-9]/ {
    scene = unquoted($2)
    choice = unquoted($8)
    if ($10 == "cpu") {
        if ((scene, choice) in error)
            cpu[scene, choice] = $13
        next
    }
    if ($13 > 0 && !(scene in scene_known)) { scene_known[scene]; scenes[++scene_count] = scene }
    if (!(choice in choice_known)) { choice_known[choice]; choices[++choice_count] = choice }
    error[scene, choice] = $13
}

function has(scene, choice) { return (scene, choice) in cpu }

function fastest(scene, error_most,   i, least) {
    least = 1e9
    for (i = 1; i <= choice_count; i++)
        if (has(scene, choices[i]) && error[scene, choices[i]] <= error_most && cpu[scene, choices[i]] < least)
            least = cpu[scene, choices[i]]
    return least
}

# Of what reaches that; 1e9: nothing does.
function least_time(scene, error_most) {
    if (!((scene, error_most) in least_times))
        least_times[scene, error_most] = fastest(scene, error_most)
    return least_times[scene, error_most]
}

function can_reach(scene, error_asked) { return least_time(scene, error_asked) < 1e9 }

# The CPU time of a choice over that of the fastest that errs no more.
function behind(scene, choice) { return cpu[scene, choice] / least_time(scene, error[scene, choice]) }

# Into place i of the ladder of n; how long it is then.
function insert(n, i, choice, front_share,   k) {
    for (k = n; k >= i; k--) {
        ladder[k + 1] = ladder[k]
        fronts[k + 1] = fronts[k]
    }
    ladder[i] = choice
    fronts[i] = front_share
    return n + 1
}

function drop(n, i) {
    for (; i < n; i++) {
        ladder[i] = ladder[i + 1]
        fronts[i] = fronts[i + 1]
    }
    return n - 1
}

# Into ladder[1..n], which it returns; without = a scene, or "".
function list_fronts(without,   i, k, n, of, on_front, sum, c, means) {
    n = 0
    for (i = 1; i <= choice_count; i++) {
        of = on_front = sum = 0
        c = choices[i]
        for (k = 1; k <= scene_count; k++)
            if (scenes[k] != without && has(scenes[k], c)) {
                of++
                on_front += behind(scenes[k], c) < 1.05
                sum += log(cpu[scenes[k], c] / fastest(scenes[k], 1e9))
            }
        if (on_front == 0 || c == "unshadowed")
            continue
        means[c] = sum / of
        for (k = n; k > 0 && means[ladder[k]] > means[c]; k--)
            ;
        n = insert(n, k + 1, c, on_front / of)
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

# Of all scenes but that: logarithms of times over those of the fastest that reach what is asked for, or else err no more.
function loss(n, without,   k, i, sum, taken, most) {
    for (k = 1; k <= scene_count; k++)
        for (i = 1; i <= learnt_askeds && scenes[k] != without; i++) {
            taken = take(scenes[k], n, learnt_asked[i])
            if (taken == "")
                return 1e9
            most = learnt_asked[i]
            if (error[scenes[k], taken] > most) {
                if (can_reach(scenes[k], most))
                    sum += miss
                most = error[scenes[k], taken]
            }
            sum += log(cpu[scenes[k], taken] / least_time(scenes[k], most))
        }
    return sum
}

# The rung of the fewest fronts that was not tried yet; 0: all were.
function next_to_try(n, tried,   i, rarest) {
    for (i = 1; i <= n; i++)
        if (!(ladder[i] in tried) && (!rarest || fronts[i] < fronts[rarest]))
            rarest = i
    return rarest
}

function make_ladder(without,   n, i, c, share, now, then, tried) {
    n = list_fronts(without)
    now = loss(n, without)
    while (i = next_to_try(n, tried)) {
        c = ladder[i]
        share = fronts[i]
        tried[c]
        n = drop(n, i)
        then = loss(n, without)
        if (then > now + 1e-6)
            n = insert(n, i, c, share)
        else
            now = then
    }
    return n
}

function cell(scene, n, error_asked,   taken, ratio) {
    taken = take(scene, n, error_asked)
    ratio = sprintf("%.2f", behind(scene, taken))
    if (error[scene, taken] <= error_asked)
        return ratio
    return can_reach(scene, error_asked) ? "missed" : "(" ratio ")"
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
