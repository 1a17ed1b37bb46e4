# Draws what `manylight bench quality --csv FILE` wrote of one or more scenes (files put together, headings but the first left
# out), with gnuplot 5.4:
#
#     gnuplot -e "csv='FILE.csv'; folder='DIR'" bench/parsimony.gp
#
# DIR/estimated: estimated errors of choices against measured ones, of all scenes and cameras. DIR/SCENE-quality: time against error of the
# ladder's choices, of fixed settings, and of what was chosen for 2, 4, 8, 16 and 30 %. Each as .svg and .png.

set datafile separator comma
set datafile columnheaders
set datafile missing NaN
set encoding utf8
set key outside right top vertical Left reverse noenhanced
set grid lc rgb '#dddddd'
set border lc rgb '#444444'
set logscale xy
set autoscale fix
set offsets graph .06, graph .06, graph .06, graph .06

# Decades in three.
set xtics ("" 1e300)
set ytics ("" 1e300)
do for [d = -1:6] {
    do for [t in "1 2 5"] {
        set xtics add (t * 10.0**d)
        set ytics add (t * 10.0**d)
    }
}

colors = "#1b3a6b #b5341b #2f7d4f #7a4fa3 #8a6d1a #1f8a99 #a33a77 #555555 #4f6bd1 #c77d2e"
marks = "7 4 9 12 5 6 11 8 13 10"
do for [i = 1:30] {
    color = 1 + (i - 1) % 10
    set linetype i lc rgb word(colors, color) pt int(word(marks, 1 + (color + (i - 1) / 10 * 3 - 1) % 10)) ps 1.1 lw 1.3
}
set linetype cycle 30

svg = "set terminal svg size 900,560 font 'DejaVu Sans,11' background 'white' noenhanced"
png = "set terminal pngcairo size 1350,840 fontscale 1.3 font 'DejaVu Sans,11' noenhanced"

is(column, text) = strcol(column) eq text
add(list, name) = strstrt(list, '"' . name . '"') ? list : list . ' "' . name . '"'

# Those that have indirect light to err in, and times.
scenes = ""
has_error(x) = is("mode", "quality") && is("variant", "ladder") && is("what", "error") && column("value") > 0 && column("value") < 1e9
stats csv using (has_error(0) ? (scenes = add(scenes, strcol("scene")), 0) : 0) nooutput

# The subject's rows come in order: its error first, then its CPU time, then its estimated error.
last_error = NaN
last_cpu = NaN
error_of(x) = is("what", "error") ? (last_error = column("value"), NaN) : x
estimated(scene) = error_of(is("scene", scene) && is("what", "told") ? last_error : NaN)
cpu(scene, variant) = error_of(is("scene", scene) && is("variant", variant) && is("what", "cpu") ? column("value") : NaN)

set title "estimated and measured errors of --max-error" noenhanced
set xlabel "relative RMSE of indirect light against the reference, %"
set ylabel "estimated, %"
do for [type in "svg png"] {
    eval(value(type))
    set output folder . "/estimated." . type
    plot x with lines lc rgb '#bbbbbb' lw 3 title "as estimated", \
        1.2 * x with lines lc rgb '#bbbbbb' dt 2 title "a fifth more or less", x / 1.2 with lines lc rgb '#bbbbbb' dt 2 notitle, \
        for [i = 1:words(scenes)] csv using (estimated(word(scenes, i))):(column("value")) \
            with points lt i title word(scenes, i)
    unset output
}

set xlabel "CPU time of a frame, or of all passes, ms"
set ylabel "relative RMSE of indirect light, %"
do for [i = 1:words(scenes)] {
    scene = word(scenes, i)
    set title scene noenhanced
    do for [type in "svg png"] {
        eval(value(type))
        set output folder . "/" . scene . "-quality." . type
        plot csv using (cpu(scene, "fixed")):(last_error) with points lt 8 title "fixed settings", \
            csv using (cpu(scene, "ladder")):(last_error) with points lt 1 title "the ladder's", \
            csv using (cpu(scene, "automatic")):(last_error) with points pt 6 ps 2.6 lw 2 lc rgb "#b5341b" \
                title "chosen for 2 to 30 %"
        unset output
    }
}
