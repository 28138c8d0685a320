-- Frequent questions about wiping. They are views of wisch-fleet; other engines over the same Parquet files can use them too.
-- Means are computed from decimals, whose sums do not depend on the order. An answer is therefore the same for any number of threads and machines.

-- Episodes with a final estimated performance of 80 % or less.
CREATE VIEW low_performance AS
SELECT robot, day, episode, task, tool, medium, surface, performance, performance_low, performance_high
FROM episodes
WHERE performance <= 0.8;

-- Rounds with an estimated performance of 80 % or less, even if a later round improved it.
CREATE VIEW low_performance_rounds AS
SELECT robot, day, episode, round, tool, medium, surface, performance
FROM rounds
WHERE performance <= 0.8 AND (verdict IS NULL OR verdict NOT IN ('performance unknown', 'cannot be told'));

-- Number of collisions with a human, by tool and hour of the day (UTC).
CREATE VIEW collisions_by_tool_and_hour AS
SELECT tool, CAST(floor(start_s / 3600.0) AS BIGINT) % 24 AS hour, count(*) AS collisions
FROM events
WHERE class IN ('Collision', 'HumanCollision')
GROUP BY tool, CAST(floor(start_s / 3600.0) AS BIGINT) % 24;

-- Peak force [N] and time of each collision.
CREATE VIEW peak_force_per_collision AS
SELECT robot, day, episode, round, place, tool, start_s, end_s, peak_force_n
FROM events
WHERE class IN ('Collision', 'HumanCollision') AND peak_force_n IS NOT NULL;

-- Strokes without contact: in contact for at most 1 % of their time.
CREATE VIEW strokes_without_contact AS
SELECT robot, day, episode, round, place, stroke, tool, surface, contact_share
FROM strokes
WHERE contact_share <= 0.01;

-- Each round with ground truth, and whether the interval of the estimate contains the true performance.
CREATE VIEW estimates AS
SELECT robot, day, episode, round, tool, medium, surface, performance, performance_low, performance_high, true_performance,
       true_performance BETWEEN performance_low AND performance_high AS held
FROM rounds
WHERE true_performance IS NOT NULL AND performance IS NOT NULL;

-- Calibration of estimates by tool and surface: number of rounds, share whose interval contains the ground truth, mean error, mean width.
CREATE VIEW calibration AS
SELECT tool, surface, count(*) AS rounds, avg(CASE WHEN held THEN 1.0 ELSE 0.0 END) AS held_share,
       CAST(avg(CAST(performance - true_performance AS DECIMAL(38, 15))) AS DOUBLE) AS mean_error,
       CAST(avg(CAST(performance_high - performance_low AS DECIMAL(38, 15))) AS DOUBLE) AS mean_width
FROM estimates
GROUP BY tool, surface;

-- Surfaces whose mean contact force [N] in the first rounds decreases significantly over at least five episodes: decrease
-- per episode, and both ends of the fitted line.
CREATE VIEW contact_force_drift AS
SELECT surface, episodes, slope_n, first_n, last_n
FROM (
    SELECT surface, episodes, slope_n, intercept_n AS first_n, intercept_n + slope_n * (episodes - 1) AS last_n
    FROM (
        SELECT surface, count(*) AS episodes, regr_slope(force_n, number) AS slope_n, regr_intercept(force_n, number) AS intercept_n
        FROM (
            SELECT surface, abs(mean_normal_force_n) AS force_n,
                   CAST(row_number() OVER (PARTITION BY surface ORDER BY start_s, episode) - 1 AS DOUBLE) AS number
            FROM rounds
            WHERE round = 1 AND mean_normal_force_n IS NOT NULL
        ) AS series
        GROUP BY surface
    ) AS fitted
    WHERE episodes >= 5
) AS lines
WHERE last_n < 0.95 * first_n;

-- Warnings of the memory while a robot wiped, with the deviation of the value from its band [N, m or 1], and how the round ended.
CREATE VIEW warnings AS
SELECT w.robot, w.day, w.episode, w.round, w.place, w.start_s AS time_s, r.tool, r.medium, r.surface, w.channel,
       CASE w.channel WHEN 'contact force' THEN 'N' WHEN 'contact share' THEN '1' WHEN 'height' THEN 'm'
                      WHEN 'tracking error' THEN 'm' END AS unit,
       w.value, w.band_low, w.band_high,
       CASE WHEN w.value > w.band_high THEN w.value - w.band_high
            WHEN w.value < w.band_low THEN w.value - w.band_low
            WHEN w.value BETWEEN w.band_low AND w.band_high THEN 0.0 END AS deviation,
       w.p_value, w.alike_episodes, r.ending, r.verdict
FROM events AS w
JOIN rounds AS r ON w.episode = r.episode AND w.round = r.round
WHERE w.class = 'MemoryWarning';

-- Each pair of a collision and a stroke that overlap in time.
CREATE VIEW collisions_in_strokes AS
SELECT c.robot, c.day, c.episode, c.round, c.place AS collision, s.place AS stroke_place, s.stroke, c.tool, c.peak_force_n,
       s.mean_normal_force_n AS stroke_mean_normal_force_n,
       least(c.end_s, s.end_s) - greatest(c.start_s, s.start_s) AS overlap_s
FROM events AS c
JOIN strokes AS s ON c.episode = s.episode AND c.start_s < s.end_s AND s.start_s < c.end_s
WHERE c.class IN ('Collision', 'HumanCollision');
