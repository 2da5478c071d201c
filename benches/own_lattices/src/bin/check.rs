//! Compares every lattice with Kahan's map of a separately written field. That map solves its
//! linear system by dense elimination.
use kahan_bench_own_lattices::*;
use kahan_core::prelude::*;

/// Solves (I - eps f'(x)) (y - x) = 2 eps f(x) for y. The Jacobian f' by central differences is
/// exact for a quadratic field f.
fn kahan(f: &dyn Fn(&[f64]) -> Vec<f64>, x: &[f64], eps: f64) -> Vec<f64> {
    let n = x.len();
    let mut a = vec![vec![0.0; n + 1]; n];
    for j in 0..n {
        let (mut up, mut down) = (x.to_vec(), x.to_vec());
        up[j] += 1.0;
        down[j] -= 1.0;
        let (up, down) = (f(&up), f(&down));
        for i in 0..n {
            a[i][j] = f64::from(u8::from(i == j)) - eps * 0.5 * (up[i] - down[i]);
        }
    }
    for (row, f) in a.iter_mut().zip(f(x)) {
        row[n] = 2.0 * eps * f;
    }
    for k in 0..n {
        let p = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap();
        a.swap(k, p);
        for i in k + 1..n {
            let m = a[i][k] / a[k][k];
            for j in k..=n {
                a[i][j] -= m * a[k][j];
            }
        }
    }
    let mut y = vec![0.0; n];
    for k in (0..n).rev() {
        y[k] = (a[k][n] - (k + 1..n).map(|j| a[k][j] * y[j]).sum::<f64>()) / a[k][k];
    }
    y.iter().zip(x).map(|(y, x)| x + y).collect()
}

struct Rng(u64);
impl Rng {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn compare<M: LatticeMap<f64>>(
    name: &str,
    map: &M,
    n: usize,
    eps: f64,
    f: &dyn Fn(&[f64]) -> Vec<f64>,
    rng: &mut Rng,
) -> f64 {
    let mut worst = 0.0_f64;
    for _ in 0..3 {
        let x: Vec<f64> = (0..n * M::BLOCK).map(|_| 2.0 * rng.next() - 0.5).collect();
        let mine = kahan(f, &x, eps);
        let mut chain = map.at(eps, n).unwrap();
        let (mut y, mut z) = (x.clone(), x.clone());
        chain.step(&mut y);
        let tried = chain.try_step(&mut z);
        assert!(tried.is_ok(), "{name} {n} {tried:?}");
        let size = mine.iter().fold(1.0_f64, |s, x| s.max(x.abs()));
        for (a, (b, c)) in mine.iter().zip(y.iter().zip(&z)) {
            worst = worst.max((a - b).abs() / size).max((a - c).abs() / size);
        }
        let field = chain.field(&x);
        for (a, b) in f(&x).iter().zip(field.iter()) {
            worst = worst.max((a - b).abs() / (1.0 + a.abs()));
        }
        chain.step_back(&mut y);
        for (a, b) in x.iter().zip(&y) {
            worst = worst.max((a - b).abs());
        }
    }
    if worst > 1e-12 {
        println!("{name} {n} sites: {worst:.1e}");
    }
    worst
}

fn main() {
    let mut rng = Rng(88172645463325252);
    for eps in [0.01, 0.1, 0.3] {
        for n in (1..40).chain([63, 64, 65, 100, 129, 200]) {
            let at = |x: &[f64], i: i64| x[i.rem_euclid(n as i64) as usize];
            let r: Vec<f64> = (0..n).map(|_| rng.next()).collect();
            let (l, g): (Vec<f64>, Vec<f64>) = (0..n).map(|_| (rng.next(), rng.next())).unzip();
            let open = |x: &[f64], k: usize, i: i64| {
                if i < 0 || i >= n as i64 { 0.0 } else { x[2 * i as usize + k] }
            };
            let ring = |x: &[f64], k: usize, i: i64| x[2 * i.rem_euclid(n as i64) as usize + k];
            let sites = |f: &dyn Fn(i64) -> [f64; 2]| (0..n as i64).flat_map(f).collect::<Vec<f64>>();
            let mut w = 0.0_f64;
            w = w.max(compare(
                "predator",
                &PredatorPrey { du: 0.2, dv: 0.5, grow: r.clone(), eat: 0.9, die: 0.4 },
                n,
                eps,
                &|x| {
                    sites(&|i| {
                        let (u, v) = (open(x, 0, i), open(x, 1, i));
                        [
                            u * (r[i as usize] - u - 0.9 * v)
                                + 0.2 * (open(x, 0, i - 1) - 2.0 * u + open(x, 0, i + 1)),
                            v * (0.9 * u - 0.4) + 0.5 * (open(x, 1, i - 1) - 2.0 * v + open(x, 1, i + 1)),
                        ]
                    })
                },
                &mut rng,
            ));
            w = w.max(compare(
                "noflux",
                &NoFlux { left: l.clone(), right: r.clone(), grow: g.clone() },
                n,
                eps,
                &|x| {
                    sites(&|i| {
                        let (u, v) = (open(x, 0, i), open(x, 1, i));
                        let k = i as usize;
                        [
                            u * (g[k] - u - v)
                                + r[k] * (open(x, 0, i + 1) - u)
                                + l[k] * (open(x, 0, i - 1) - u),
                            v * (u - 1.0) + r[k] * (open(x, 1, i + 1) - v) + l[k] * (open(x, 1, i - 1) - v),
                        ]
                    })
                },
                &mut rng,
            ));
            w = w.max(compare(
                "bogo",
                &Bogoyavlensky,
                n,
                eps,
                &|x| {
                    (0..n as i64)
                        .map(|i| {
                            at(x, i)
                                * (at(x, i + 1) + at(x, i + 2) + at(x, i + 3)
                                    - at(x, i - 1)
                                    - at(x, i - 2)
                                    - at(x, i - 3))
                        })
                        .collect()
                },
                &mut rng,
            ));
            w = w.max(compare(
                "flux",
                &Flux { c: 0.3 },
                n,
                eps,
                &|x| {
                    (0..n as i64)
                        .map(|i| {
                            0.3 * (at(x, i + 2) * at(x, i + 3) - at(x, i - 1) * at(x, i)) + at(x, i + 1)
                                - 2.0 * at(x, i)
                                + at(x, i - 1)
                        })
                        .collect()
                },
                &mut rng,
            ));
            w = w.max(compare(
                "wave",
                &Wave { h: 0.5 },
                n,
                eps,
                &|x| {
                    sites(&|i| {
                        let (a, b, c) = (ring(x, 0, i - 1), ring(x, 0, i), ring(x, 0, i + 1));
                        [ring(x, 1, i), (c - 2.0 * b + a) * 4.0 + (c * c - a * a) * 0.5]
                    })
                },
                &mut rng,
            ));
            let fput = |u: [f64; 3]| {
                u[2] - 2.0 * u[1] + u[0] + 0.25 * ((u[2] - u[1]).powi(2) - (u[1] - u[0]).powi(2))
            };
            w = w.max(compare(
                "fput",
                &Fput { alpha: 0.25 },
                n,
                eps,
                &|x| sites(&|i| [ring(x, 1, i), fput([i - 1, i, i + 1].map(|i| ring(x, 0, i)))]),
                &mut rng,
            ));
            w = w.max(compare(
                "fput open",
                &FputOpen { alpha: 0.25 },
                n,
                eps,
                &|x| sites(&|i| [open(x, 1, i), fput([i - 1, i, i + 1].map(|i| open(x, 0, i)))]),
                &mut rng,
            ));
            // The bound allows for ill-conditioned steps, such as some at ε = 0.3, which lose
            // digits.
            assert!(w < 1e-9, "eps {eps}, {n} sites: {w:e}");
            if n % 20 == 1 {
                println!("eps {eps}, {n} sites: largest difference {w:.1e}");
            }
        }
    }
    // This block has the equations of `PredatorPrey` for three sites.
    let plain = {
        let (du, dv, eat, die) = (0.2, 0.5, 0.9, 0.4);
        let (r0, r1, r2) = (0.5, 1.0, 1.5);
        kahan! {
            u0dot = u0*(r0 - u0 - eat*v0) + du*(u1 - 2*u0);
            v0dot = v0*(eat*u0 - die) + dv*(v1 - 2*v0);
            u1dot = u1*(r1 - u1 - eat*v1) + du*(u0 - 2*u1 + u2);
            v1dot = v1*(eat*u1 - die) + dv*(v0 - 2*v1 + v2);
            u2dot = u2*(r2 - u2 - eat*v2) + du*(u1 - 2*u2);
            v2dot = v2*(eat*u2 - die) + dv*(v1 - 2*v2);
        }
    };
    let mut chain =
        PredatorPrey { du: 0.2, dv: 0.5, grow: vec![0.5, 1.0, 1.5], eat: 0.9, die: 0.4 }.at(0.05, 3).unwrap();
    let mut x = vec![0.5, 0.4, 0.6, 0.3, 0.7, 0.2];
    let mut y = vector![0.5_f64, 0.4, 0.6, 0.3, 0.7, 0.2];
    for _ in 0..1000 {
        chain.step(&mut x);
        y = plain.step(&y, 0.05);
    }
    println!(
        "1000 steps against the plain block: {:.1e}",
        x.iter().zip(&y).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    );
}
