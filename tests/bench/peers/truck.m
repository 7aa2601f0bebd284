% SPDX-License-Identifier: MIT
% truck.m FILE: the thesis's Newmark loop in M code, and ode45, on the truck of the benchmark.
% Prints a line "name;seconds;error" for each.
1;

function [s, ds] = road(p, t)
  ratio = exp(p.growth * t);
  f = p.frequency * ratio;
  phase = 2 * pi * p.frequency / p.growth * (ratio - 1);
  a = p.amplitude ./ f;
  s = a .* sin(phase);
  ds = a .* (2 * pi * f .* cos(phase) - p.growth * sin(phase));
end

% Forces B' f of all damper curves and their tangent damping; pieces as polynomials.
function [f, c] = dampers(p, v)
  rate = p.rows * v;
  force = zeros(size(rate));
  slope = force;
  for k = 1:numel(rate)
    t = p.tables(k);
    i = lookup(t.breaks, rate(k), "lr");
    d = rate(k) - t.breaks(i);
    piece = t.pieces(i, :);
    force(k) = ((piece(1) * d + piece(2)) * d + piece(3)) * d + piece(4);
    slope(k) = (3 * piece(1) * d + 2 * piece(2)) * d + piece(3);
  end
  f = p.rows' * force;
  if nargout > 1
    c = p.rows' * (slope .* p.rows);
  end
end

function dy = right_side(p, t, y)
  v = y(p.n+1:end);
  [s, ds] = road(p, t);
  r = p.of_height * s + p.of_rate * ds - p.stiffness * y(1:p.n) - p.damping * v - dampers(p, v);
  dy = [v; p.mass \ r];
end

% Predictor, then corrections by S = K + gamma/(beta h) C + 1/(beta h^2) M until the residual is
% small beside the forces (thesis, equations 24 to 35).
function q = newmark(p, h, steps, every, beta, gamma)
  q = zeros(steps / every + 1, p.n);
  x = zeros(p.n, 1);
  v = x;
  [s, ds] = road(p, 0);
  a = p.mass \ (p.of_height * s + p.of_rate * ds - dampers(p, v));
  for k = 1:steps
    [s, ds] = road(p, k * h);
    load = p.of_height * s + p.of_rate * ds;
    x += h * v + h^2 * (0.5 - beta) * a;
    v += h * (1 - gamma) * a;
    a(:) = 0;
    for iteration = 1:20
      [f, c] = dampers(p, v);
      force = p.damping * v + f + p.stiffness * x - load;
      r = p.mass * a + force;
      if norm(r, inf) <= 1e-8 * norm(p.mass * a, inf) + 1e-9
        break
      end
      S = p.stiffness + gamma / (beta * h) * (p.damping + c) + 1 / (beta * h^2) * p.mass;
      dx = -S \ r;
      x += dx;
      v += gamma / (beta * h) * dx;
      a += 1 / (beta * h^2) * dx;
    end
    if mod(k, every) == 0
      q(k / every + 1, :) = x';
    end
  end
end

function e = relative_error(q, wanted)
  e = max(max(abs(q - wanted)) ./ max(abs(wanted)));
end

p = jsondecode(fileread(argv(){1}));
samples = rows(p.q) - 1;
times = p.sample * (0:samples);

start = cputime();
every = round(p.sample / 1e-3);
q = newmark(p, 1e-3, every * samples, every, 0.25, 0.5);
printf("Newmark, 1 ms;%.6g;%.6g\n", cputime() - start, relative_error(q, p.q));
for rtol = [1e-3 1e-4 1e-5 1e-6 1e-7]
  options = odeset("RelTol", rtol, "AbsTol", 1e-3 * rtol);
  start = cputime();
  [t, y] = ode45(@(t, y) right_side(p, t, y), times, zeros(2 * p.n, 1), options);
  seconds = cputime() - start;
  e = relative_error(y(:, 1:p.n), p.q);
  if e <= p.target
    printf("ode45 rtol %.0e;%.6g;%.6g\n", rtol, seconds, e);
    break
  end
end
