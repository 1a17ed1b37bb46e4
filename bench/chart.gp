# Draws a file of figures, as `manylight bench MODE --csv FILE` writes them, with gnuplot 5.4:
#
#     gnuplot -e "csv='FILE.csv'; folder='DIR'" bench/chart.gp
#
# A sweep against a reference: DIR/SCENE, time against error; of direct light: DIR/SCENE-direct, of the share that is seen. Curves: DIR/SCENE-SETTING. Passes:
# DIR/SCENE-passes. A clip: DIR/SCENE-flicker and DIR/SCENE-vals-in-use. Each as .svg and .png; of two scenes of one name the
# second tells its faces too.

set datafile separator comma
set datafile columnheaders
set datafile missing NaN
set encoding utf8
set key outside right top vertical Left reverse noenhanced
set grid lc rgb '#dddddd'
set border lc rgb '#444444'
set style data linespoints
drawn = 0

# Series differ by mark, dash and grey as well as by colour, so that a black and white print reads.
colors = "#1b3a6b #b5341b #2f7d4f #7a4fa3 #8a6d1a #1f8a99 #a33a77 #555555 #4f6bd1 #c77d2e #0a0a0a"
marks = "7 4 9 12 5 6 11 8 13 10 3"
do for [i = 1:11] {
    set linetype i lc rgb word(colors, i) pt int(word(marks, i)) ps 1.1 dt 1 + (i - 1) % 5 lw 1.3
}
set linetype cycle 11

svg = "set terminal svg size 900,560 font 'DejaVu Sans,11' background 'white' noenhanced"
png = "set terminal pngcairo size 1350,840 fontscale 1.3 font 'DejaVu Sans,11' noenhanced"

# --- reading --------------------------------------------------------------------------------------

# Lists of names, each once, in quotes for word().
add(list, name) = strstrt(list, '"' . name . '"') ? list : list . ' "' . name . '"'
is(column, text) = strcol(column) eq text

# What stands on the two sides of "KEY=VALUE", and "vals=2 terms=4" as "M=2 K=4".
key(point) = point[1:strstrt(point, "=") - 1]
number(point) = real(point[strstrt(point, "=") + 1:*])
replace(text, old, new) = strstrt(text, old) ? \
    text[1:strstrt(text, old) - 1] . new . text[strstrt(text, old) + strlen(old):*] : text
letters(text) = replace(replace(replace(text, "vpls=", "N="), "vals=", "M="), "terms=", "K=")

# A scene by its name, as one word that is no path, and its faces.
plain(name) = strstrt(name, "/") ? plain(replace(name, "/", "-")) : strstrt(name, " ") ? plain(replace(name, " ", "-")) : \
    strstrt(name, '"') ? plain(replace(name, '"', "-")) : strlen(name) ? name : "unnamed"
place_of(name, faces) = plain(strcol(name)) . " " . strcol(faces)

# The chart that a row belongs to: of a sweep "time", of curves the setting, of a clip the measured quantity.
error(what) = what eq "relative-rmse" || what eq "gradient"
chart_of(mode, what) = \
    mode eq "sweep" && what eq "relative-rmse" && strlen(strcol("frame_ms")) ? "time" : \
    mode eq "direct" && what eq "visible-share" ? "direct" : \
    mode eq "curves" && error(what) ? key(strcol("point")) : \
    mode eq "passes" && (what eq "error" || what eq "relative-mae") ? "passes" : \
    mode ne "temporal" || strcol("point") eq "time=0" ? "" : \
    what eq "frame-flicker" ? "flicker" : what eq "vals" ? "vals in use" : ""

# Of the subject at hand, whose rows follow each other: the time of all cores, where these are what draws. Other work on the
# machine lengthens it less than the time by the clock.
cpu = 0
note_cpu(what) = what eq "clock" ? (cpu = 0) : \
    what eq "cpu" && is("software", "yes") ? (cpu = column("value")) : cpu
on(scene, chart) = (note_cpu(strcol("what")), place_of("scene", "faces") eq scene && \
    chart_of(strcol("mode"), strcol("what")) eq chart)
is_timed(chart) = chart eq "time" || chart eq "direct"
x(chart) = is_timed(chart) ? (cpu > 0 ? cpu : column("frame_ms")) : number(strcol("point"))
y(chart) = is("what", "gradient") ? 100 * column("value") : column("value")
series(mode, what) = \
    mode eq "passes" ? (strlen(strcol("variant")) ? strcol("variant") . ", " : "") . \
        (what eq "error" ? "RMSE" : "mean of the magnitude") : \
    mode ne "curves" ? strcol("variant") : \
    strcol("variant") . (what eq "gradient" ? ", gradient" : ", RMSE")

# --- what stands at its sides ---------------------------------------------------------------------

is_clip(chart) = chart eq "flicker" || chart eq "vals in use"
x_label(chart) = is_timed(chart) ? (cpu > 0 ? "CPU time of a frame, ms" : "time of a frame, ms") : is_clip(chart) ? "time, s" : \
    chart eq "passes" ? "passes, K" : chart eq "vals" ? "VALs, M" : chart eq "vpls" ? "VPLs, N" : \
    chart eq "terms" ? "terms of the Fourier series, K" : \
    chart eq "map-size" ? "paraboloid map, texels a side" : chart
y_label(chart) = chart eq "time" ? "relative RMSE of indirect light, %" : \
    chart eq "direct" ? "RMS error of the share of the lights that is seen, %" : \
    chart eq "flicker" ? "flicker, %" : chart eq "vals in use" ? "VALs in use" : \
    "error of indirect light over its mean, %"
head_of(name, faces) = strcol(name) . " (" . strcol(faces) . " faces), " . strcol("width") . "x" . \
    strcol("height") . ", " . word(strcol("gl_renderer"), 1)

# Ticks of a logarithmic axis.
ticks(low, high) = high < 20 * low ? "1 1.2 1.5 2 2.5 3 4 5 6 8" : "1 2 5"

scenes = ""
all = ""
stats csv using (scenes = add(scenes, place_of("scene", "faces")), \
    strlen(chart_of(strcol("mode"), strcol("what"))) ? \
        (all = add(all, series(strcol("mode"), strcol("what"))), 0) : 0) nooutput
# The same of a series, and its place in the legend, in all charts of a file.
line_type(name) = sum [k = 1:words(all)] (word(all, k) eq name ? k : 0)

name_of(i) = word(word(scenes, i), 1)
same_before(i) = i > 1 ? (sum [k = 1:i - 1] (name_of(k) eq name_of(i))) : 0
file_of(i, chart) = folder . "/" . name_of(i) . \
    (same_before(i) ? "-" . word(word(scenes, i), 2) : "") . \
    (chart eq "time" ? "" : "-" . plain(chart))

# The Pareto front: what no other case is both as fast and as true as.
array X[10000]
array Y[10000]
beaten(x, y) = sum [k = 1:n] (X[k] <= x && Y[k] <= y && (X[k] < x || Y[k] < y))
front(scene, chart) = is_timed(chart) && on(scene, chart) && !beaten(x(chart), y(chart))

pareto = \
    'csv using (front(scene, chart) ? x(chart) : NaN):(y(chart)) smooth unique with steps \
         lc rgb "#bbbbbb" lw 4 dt 1 title "Pareto front", \
     csv using (front(scene, chart) ? x(chart) : NaN):(y(chart)) with points \
         pt 6 ps 2.6 lw 1.5 lc rgb "#777777" notitle, \
     csv using (on(scene, chart) ? x(chart) : NaN):(y(chart)):(letters(strcol("point"))) \
         with labels left offset 0.8,0.6 font ",9" noenhanced notitle'
curves = \
    'for [v = 1:words(names)] csv using (on(scene, chart) && \
         series(strcol("mode"), strcol("what")) eq word(names, v) ? x(chart) : NaN):(y(chart)) \
         lt line_type(word(names, v)) title word(names, v)'

# --- drawing --------------------------------------------------------------------------------------

do for [i = 1:words(scenes)] {
    scene = word(scenes, i)
    charts = ""
    unset logscale
    set autoscale
    stats csv using (place_of("scene", "faces") eq scene && \
        strlen(chart_of(strcol("mode"), strcol("what"))) ? \
        (charts = add(charts, chart_of(strcol("mode"), strcol("what"))), 0) : 0) nooutput
    do for [c = 1:words(charts)] {
        chart = word(charts, c)
        names = ""
        n = 0
        low_x = 1e300; high_x = 0; low_y = 1e300; high_y = 0
        unset logscale
        set autoscale
        stats csv using (on(scene, chart) ? (n = n + 1, X[n] = x(chart), Y[n] = y(chart), \
            low_x = X[n] < low_x ? X[n] : low_x, high_x = X[n] > high_x ? X[n] : high_x, \
            low_y = Y[n] < low_y ? Y[n] : low_y, high_y = Y[n] > high_y ? Y[n] : high_y, \
            names = add(names, series(strcol("mode"), strcol("what"))), \
            head = head_of("scene", "faces"), 0) : 0) nooutput
        seen = names
        names = ""
        do for [v = 1:words(all)] {
            if (strstrt(seen, '"' . word(all, v) . '"')) { names = add(names, word(all, v)) }
        }
        set title head noenhanced
        set xlabel x_label(chart)
        set ylabel y_label(chart)
        set xtics autofreq
        set ytics autofreq
        set yrange [0:high_y * 1.25]
        if (!is_clip(chart)) {
            set logscale xy
            set xrange [low_x / 1.25:high_x * 1.25]
            set yrange [low_y / 1.25:high_y * 1.25]
            set xtics ("" 1e300)
            set ytics ("" 1e300)
            do for [d = -4:6] {
                do for [t in ticks(low_x, high_x)] { set xtics add (t * 10.0**d) }
                do for [t in ticks(low_y, high_y)] { set ytics add (t * 10.0**d) }
            }
        }
        do for [type in "svg png"] {
            eval(value(type))
            name = file_of(i, chart) . "." . type
            set output name
            eval("plot " . (is_timed(chart) ? pareto . ", " : "") . curves)
            unset output
            drawn = drawn + 1
        }
    }
}

if (drawn == 0) { printerr csv . ": nothing to draw"; exit status 1 }
