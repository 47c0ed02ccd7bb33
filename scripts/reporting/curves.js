// SPDX-License-Identifier: GPL-3.0-or-later
// Draw what is chosen: one curve along an axis for each value of the other swept variables, or for the one of its slider.
const x_name = choose.x.value, y_name = choose.y.value
const axes_of = (run) => run.axes.filter((axis) => axis.values.length > 1)

// A variable along x that is spread over decades is drawn so, unless the axes were chosen.
if (cb_obj === choose.x || cb_obj === null || cb_obj.type === undefined || cb_obj.type === 'Document') {
  const is_log = runs.every((run) => run.axes.some((axis) => axis.name === x_name && axis.log))
  const wanted = is_log ? scales[1] : scales[0]
  if (choose.scale.value !== wanted) choose.scale.value = wanted
}

const lines = {xs: [], ys: [], colour: [], label: []}
const points = {x: [], y: [], colour: [], label: [], x_text: [], y_text: [], note: [], size: []}
const doubts = {x: [], y: []}, missed = {x: [], y: []}
const errors = {x0: [], y0: [], x1: [], y1: [], colour: []}

// the axis of curves, and those of the others
const along_of = (run) => {
  const own = run.axes.findIndex((axis) => axis.name === x_name)
  if (own >= 0) return own
  if (x_name in run.owners) return run.owners[x_name]
  const chosen = run.axes.findIndex((axis) => axis.name === choose.along.value)
  return chosen >= 0 ? chosen : run.along
}
// every place along the axes but one that the sliders leave
const places_of = (run, along) => {
  let places = [[]]
  run.axes.forEach((axis, k) => {
    const slider = sliders[axis.name]
    const all = [...axis.values.keys()]
    const some = k === along ? [0] : slider && slider.value > 0 ? [slider.value - 1] : all
    places = places.flatMap((place) => some.map((i) => [...place, i]))
  })
  return places
}
const about = (run, name) => run.axes.find((axis) => axis.name === name) ?? run.names[name]
const text_of = (value) => Number(value.toPrecision(5)).toString().replace('-', '\u2212')

const plans = runs.map((run) => {
  const along = along_of(run)
  return {along, places: places_of(run, along)}
})
const n_curves = plans.reduce((sum, plan) => sum + plan.places.length, 0)
let number = 0, n_drawn = 0
const seen = (place) => n_curves <= most_curves || Math.floor(place * most_curves / n_curves) !== Math.floor((place - 1) * most_curves / n_curves)

runs.forEach((run, r) => {
  const data = sources[r].data, {along, places} = plans[r]
  const axis = run.axes[along]
  const strides = run.axes.map((_, k) => run.axes.slice(k + 1).reduce((size, other) => size * other.values.length, 1))
  const order = [...axis.values.keys()].sort((i, j) => axis.values[i] - axis.values[j])
  const x_axis = run.axes.findIndex((other) => other.name === x_name)
  const jumps = run.jumps.includes(axis.name) ? data[`jump along ${axis.name}`] : null
  for (const place of places) {
    const here = number++
    if (!seen(here)) continue
    n_drawn += 1
    const colour = n_curves <= colours.length ? colours[here] : palette[Math.round(here * 255 / Math.max(n_curves - 1, 1))]
    const words = run.axes.map((other, k) => k !== along && other.values.length > 1 ? other.texts[place[k]] : '').filter((text) => text)
    const label = [run.title, ...words].filter((text) => text).join(', ')
    const xs = [], ys = []
    for (const i of order) {
      const flat = place.reduce((sum, j, k) => sum + strides[k] * (k === along ? i : j), 0)
      const x = x_axis >= 0 ? axis.values[i] : data[x_name][flat], y = data[y_name][flat]
      if (data['status of point'][flat] === 2 && Number.isFinite(x)) { missed.x.push(x); missed.y.push(0) }
      xs.push(x); ys.push(y)
      if (jumps && jumps[flat]) { xs.push(NaN); ys.push(NaN) }
      if (!Number.isFinite(x) || !Number.isFinite(y)) continue
      const notes = Object.entries(run.states).map(([name, state]) => {
        const word = state.words[data[`word of ${name}`][flat]]
        return word === undefined ? '' : `${state.title}: ${word}`
      })
      points.x.push(x); points.y.push(y); points.colour.push(colour); points.label.push(label)
      points.x_text.push(`${about(run, x_name).words} ${text_of(x)} ${about(run, x_name).unit}`)
      points.y_text.push(`${about(run, y_name).words} ${text_of(y)} ${about(run, y_name).unit}`)
      points.size.push(order.length <= 40 ? 5 : 2.5)
      points.note.push([axis.name === x_name ? '' : axis.texts[i], ...notes].filter((text) => text).join(', '))
      if (data['doubted'][flat]) { doubts.x.push(x); doubts.y.push(y) }
      for (const [name, is_x] of [[x_name, true], [y_name, false]]) {
        if (!(name in run.errors)) continue
        const error = data[run.errors[name]][flat]
        if (!Number.isFinite(error)) continue
        errors.x0.push(is_x ? x - error : x); errors.x1.push(is_x ? x + error : x)
        errors.y0.push(is_x ? y : y - error); errors.y1.push(is_x ? y : y + error)
        errors.colour.push(colour)
      }
    }
    // a quotient by the load has no curve across its pole
    if (run.limits[y_name]) {
      for (let i = xs.length - 1; i > 0; i--) {
        const [low, high] = run.limits[y_name]
        if (ys[i] * ys[i - 1] < 0 && Math.abs(ys[i] - ys[i - 1]) > (high - low) / 2) { xs.splice(i, 0, NaN); ys.splice(i, 0, NaN) }
      }
    }
    if (axis.sampled) { xs.fill(NaN) }
    lines.xs.push(xs); lines.ys.push(ys); lines.colour.push(colour); lines.label.push(label)
  }
})

// ranges: what is drawn and a little more; a quotient with a pole has limits of its own
const range_of = (values, is_log, limits) => {
  let low = Infinity, high = -Infinity
  for (const value of values) {
    if (Number.isFinite(value) && (value > 0 || !is_log)) { low = Math.min(low, value); high = Math.max(high, value) }
  }
  if (low > high) return is_log ? [1, 10] : [0, 1]
  if (is_log) {
    const margin = Math.max(Math.pow(high / low, 0.03), 1.02)
    return [low / margin, high * margin]
  }
  if (limits) { low = Math.max(low, limits[0]); high = Math.min(high, limits[1]) }
  if (low > 0 && low < 0.5 * high) low = 0
  const margin = 0.03 * (high - low) || Math.abs(high) * 0.05 || 1
  return [low === 0 ? 0 : low - margin, high + margin]
}
const limits = runs.map((run) => run.limits[y_name]).filter((one) => one)
const limit = limits.length ? [Math.min(...limits.map((one) => one[0])), Math.max(...limits.map((one) => one[1]))] : null
const shown = Math.max(scales.indexOf(choose.scale.value), 0)
figures.forEach((figure, k) => {
  const is_log = [k === 1 || k === 3, k >= 2]
  const [x_range, y_range] = ranges[k]
  const found = [range_of(points.x.concat(missed.x), is_log[0], null), range_of(points.y, is_log[1], limit)]
  for (const [range, ends] of [[x_range, found[0]], [y_range, found[1]]]) {
    range.setv({start: ends[0], end: ends[1], reset_start: ends[0], reset_end: ends[1]})
  }
  if (k === shown) missed.y = missed.x.map(() => found[1][0])
  axes_x[k].axis_label = about(runs[0], x_name).label
  axes_y[k].axis_label = about(runs[0], y_name).label
  legends[k].visible = n_drawn > 1 && n_drawn <= 14
  figure.visible = k === shown
})
drawn.lines.data = lines
drawn.points.data = points
drawn.doubts.data = doubts
drawn.missed.data = missed
drawn.errors.data = errors

// sliders of what is along the curve have nothing to choose
if (runs.length === 1) {
  axes_of(runs[0]).forEach((axis) => {
    if (axis.name in sliders) sliders[axis.name].visible = runs[0].axes[plans[0].along].name !== axis.name
  })
}
choose.along.disabled = runs.some((run) => run.axes.some((axis) => axis.name === x_name) || x_name in run.owners)
const remarks = []
if (n_drawn < n_curves) remarks.push(`${n_drawn} of ${n_curves} curves are drawn; a slider chooses others.`)
if (doubts.x.length) remarks.push('Grey squares lie beyond a bound of the theory.')
if (missed.x.length) remarks.push('Red crosses did not converge.')
if (!points.x.length) remarks.push('No point has a value here.')
remark.text = remarks.join(' ')
