# Error of what balls reflect against their roughness, from bench/results/specular-200-llvmpipe.csv and, by technique,
# specular-techniques-200-llvmpipe.csv:
#
#     gnuplot bench/specular.gp
set datafile separator comma
set encoding utf8
set grid lc rgb '#dddddd'
set border lc rgb '#444444'
set key top right noenhanced
set xlabel 'roughness'
set ylabel 'relative RMSE of indirect.specular over a ball'
set logscale y
set xrange [0:1.05]
set yrange [.1:10]
csv = 'bench/results/specular-200-llvmpipe.csv'
by_technique = 'bench/results/specular-techniques-200-llvmpipe.csv'
techniques = 'clustered instant-radiosity imperfect-shadow-maps row-column lightcuts cluster-lights'
colors = '#2f7d4f #1b3a6b #b5341b #8a5fb0 #c98a1b #555555'
rows(name, material) = sprintf("< grep '^\"%s\",%s' %s", name, material, csv)
rows_of(technique, material) = sprintf("< grep '^\"%s\",%s' %s", technique, material, by_technique)
do for [kind in "svg png"] {
    if (kind eq 'svg') {
        set terminal svg size 900,560 font 'DejaVu Sans,11' background 'white' noenhanced
    } else {
        set terminal pngcairo size 1350,840 fontscale 1.3 font 'DejaVu Sans,11' noenhanced
    }
    set output 'bench/plots/specular.'.kind
    plot rows('points', 'metal') using 3:4 with linespoints lc rgb '#b5341b' pt 7 title 'VPLs as points, metal', \
         rows('points', 'plastic') using 3:4 with linespoints lc rgb '#b5341b' pt 6 dt 2 title 'plastic', \
         rows('balls, a quarter of the VPLs each', 'metal') using 3:4 with linespoints lc rgb '#1b3a6b' pt 5 title 'VPLs as balls, metal', \
         rows('balls, a quarter of the VPLs each', 'plastic') using 3:4 with linespoints lc rgb '#1b3a6b' pt 4 dt 2 title 'plastic', \
         rows('points and rays (default)', 'metal') using 3:4 with linespoints lc rgb '#2f7d4f' pt 9 title 'points and rays, metal', \
         rows('points and rays (default)', 'plastic') using 3:4 with linespoints lc rgb '#2f7d4f' pt 8 dt 2 title 'plastic'
    set output 'bench/plots/specular-techniques.'.kind
    plot for [i = 1:words(techniques)] rows_of(word(techniques, i), 'metal') using 3:4 with linespoints \
             lc rgb word(colors, i) pt 7 title word(techniques, i).', metal', \
         for [i = 1:words(techniques)] rows_of(word(techniques, i), 'plastic') using 3:4 with linespoints \
             lc rgb word(colors, i) pt 6 dt 2 title 'plastic'
}
